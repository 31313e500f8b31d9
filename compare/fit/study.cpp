#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/fit/table.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/measure/static_release.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"

// What the laws are fitted to, measured.
namespace fiberchain::compare {
namespace {

using Ratios = std::vector<int>;

constexpr double kPaperBondDamping = 1;  // of Fig 9

dem::Fiber fiber_of(const FitSweep& asked, int aspect_ratio) {
  dem::Fiber fiber = nominal_fiber(aspect_ratio, asked.poisson_ratio, dem::BondModel::paper);
  fiber.bond_damping = asked.bond_damping;
  return fiber;
}

/// xi_f of one fiber released from its own first mode with the load's small deflection: the first four peaks.
double first_mode_damping(const dem::Fiber& fiber, double load) {
  constexpr int peaks = 4;
  const reference::ChainMode mode = reference::first_bending_mode(linear_chain_of(fiber));
  if (!mode.oscillates)
    throw InputError(fmt::format("the first mode at aspect ratio {} is overdamped", fiber.aspect_ratio));
  const auto record = dem::ring_down<2>({mode_release(fiber, mode, load / 3, peaks + 0.5)}).front();
  return damping_from_peaks(positive_peaks(tip_history(record, dem::fiber_length(fiber))), {0, peaks - 1})
      .ratio;
}

/// The longest first, so that the last thread is not left with it.
std::vector<double> first_mode_dampings(const FitSweep& asked, const Ratios& aspect_ratios,
                                        const Jobs& jobs) {
  std::vector<double> found(aspect_ratios.size());
  jobs.run_dearest_first({aspect_ratios.begin(), aspect_ratios.end()}, [&](std::size_t k) {
    found[k] = first_mode_damping(fiber_of(asked, aspect_ratios[k]), asked.load);
  });
  return found;
}

std::vector<double> static_dampings(const FitSweep& asked, const Ratios& aspect_ratios, const Jobs& jobs) {
  std::vector<StaticReleaseRequest> requests;
  for (const int r_f : aspect_ratios) requests.push_back({fiber_of(asked, r_f), asked.load, {*asked.peaks}});
  std::vector<double> found;
  for (const StaticReleaseResult& result : static_release_damping(requests, jobs)) {
    found.push_back(result.damping.front().ratio);
  }
  return found;
}

void check(const FitSweep& asked) {
  if (!asked.peaks && asked.load > largest_mode_release_load) {
    throw InputError(
        fmt::format("load = {} is not allowed without a choice of peaks: at most {}, where the first mode is "
                    "released by itself",
                    asked.load, largest_mode_release_load));
  }
}

}  // namespace

FitSweep::FitSweep() {
  for (int r_f = 5; r_f <= 30; ++r_f) aspect_ratio.push_back(r_f);
}

FitStudy fit_study(const FitSweep& asked, const Jobs& jobs) {
  const ChainKind kind{asked.poisson_ratio, asked.bond_damping};
  FitStudy study{asked, {}, {}, chain_curve(kind), {}, {}};
  check(asked);
  Ratios all = asked.aspect_ratio;
  all.insert(all.end(), asked.held_out.begin(), asked.held_out.end());
  const std::vector<double> found =
      asked.peaks ? static_dampings(asked, all, jobs) : first_mode_dampings(asked, all, jobs);
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto& points = i < asked.aspect_ratio.size() ? study.points : study.held_out;
    points.push_back({all[i], found[i] / asked.bond_damping});
  }
  study.fits = damping_fits(study.points, study.held_out, study.chain);
  study.choices =
      choice_outcomes(fit_choices(), chain_slopes({asked.poisson_ratio, kPaperBondDamping}, jobs));
  return study;
}

}  // namespace fiberchain::compare
