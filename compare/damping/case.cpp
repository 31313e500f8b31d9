#include "compare/damping/case.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "compare/damping/references.hpp"
#include "compare/fit/law.hpp"
#include "compare/measure/first_mode_damping.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "dem/model/errors.hpp"
#include "dem/parallel/parallel_for.hpp"
#include "reference/errors.hpp"

namespace fiberchain::compare {
namespace {

constexpr double vanishing_load = 1e-5;

/// What is marched for one case and how its peaks are counted.
struct Plan {
  dem::Fiber fiber;
  reference::ChainMode mode;
  CleanPeaks from_mode;  ///< of the releases from the first mode
  CleanPeaks clean;      ///< of fiber_damping, from the first mode or from equilibrium
  double periods;        ///< of the static release
};

bool starts_from_mode(const Plan& plan) { return plan.clean.way == CleanPeaks::Way::mode_release; }

Plan plan_of(const DampingCase& asked) {
  const reference::LinearChain chain = linear_chain_of(asked);
  Plan plan{damped_fiber(asked), reference::first_bending_mode(chain), {}, {}, asked.peaks.last + 0.7};
  if (!plan.mode.oscillates) throw InputError("the first mode is overdamped: there is no vibration");
  plan.from_mode = mode_release_peaks(plan.mode);
  plan.clean = asked.load <= largest_mode_release_load ? plan.from_mode : clean_peaks(chain, plan.mode);
  if (!starts_from_mode(plan)) plan.periods = std::max(plan.periods, plan.clean.periods());
  return plan;
}

/// The marches of one case.
struct Marches {
  TipHistory vanishing, loaded,
      released;  ///< first mode at vanishing load, at the load (or empty), static release
  double time_step, steps;
};

std::vector<dem::Release<2>> releases_of(const DampingCase& asked, const Plan& plan) {
  const double mode_periods = plan.from_mode.periods();
  std::vector<dem::Release<2>> all{mode_release(plan.fiber, plan.mode, vanishing_load / 3, mode_periods),
                                   static_release(plan.fiber, plan.mode, asked.load, plan.periods)};
  if (starts_from_mode(plan))
    all.push_back(mode_release(plan.fiber, plan.mode, asked.load / 3, mode_periods));
  return all;
}

DampingPoint unmeasured(const DampingCase& asked, std::string why) {
  return {asked, nan, nan, nan, nan, nan,           nan, nan, nan, nan, nan, {nan, nan, nan, nan, nan},
          nan,   nan, {},  nan, 0,   std::move(why)};
}

/// Does a measurement; where it cannot be done the status says what is missing and why.
template <class Measurement>
void attempt(DampingPoint& point, const char* missing, const Measurement& measurement) {
  try {
    measurement();
  } catch (const InputError& error) {
    point.status +=
        fmt::format("{} {}: {}", point.status == "measured" ? ", but not" : ";", missing, error.what());
  }
}

void measure_motion(DampingPoint& point, const Plan& plan, const Marches& marches) {
  const double frequency = plan.mode.eigenvalue.imag();
  attempt(point, "as the paper", [&] {  // mode 2 can make the first peaks grow
    point.damping_paper = damping_from_peaks(positive_peaks(marches.released), point.asked.peaks).ratio;
  });
  attempt(point, "without mode 2", [&] {
    const TipHistory& history = starts_from_mode(plan) ? marches.loaded : marches.released;
    const FirstModeDamping found = first_mode_damping(history, plan.clean, frequency);
    point.damping = found.peaks.ratio;
    point.half_width = found.peaks.half_width;
    point.frequency = found.peaks.frequency;
    point.damping_sine = found.sine;
  });
}

DampingPoint measured(const DampingCase& asked, const Plan& plan, const Marches& marches,
                      const DampingOptions& options) {
  DampingPoint point = unmeasured(asked, "measured");
  measure_motion(point, plan, marches);
  const double vanishing =
      first_mode_damping(marches.vanishing, plan.from_mode, plan.mode.eigenvalue.imag()).peaks.ratio;
  const bool beside = options.elastica && std::isfinite(point.damping);
  const DampingReferences known = damping_references(asked, plan.mode, plan.clean, beside);
  point.damping_modes = known.modes;
  point.damping_elastica = known.elastica;
  point.damping_closed_form = known.closed_form;
  point.damping_beam = known.beam;
  point.damping_eq20 = asked.dashpots == dem::DashpotLaw::bond_damping
                           ? equation_20(asked.aspect_ratio, asked.bond_damping)
                           : nan;
  point.mode_2_estimate = known.mode_2_estimate;
  point.cvode = known.cvode;
  point.frequency_modes = plan.mode.eigenvalue.imag();
  point.time_step = marches.time_step;
  point.steps = marches.steps;
  const double beam = known.beam;
  point.budget = {(known.unsheared - beam) / beam, (known.modes - known.unsheared) / beam,
                  (vanishing - known.modes) / beam, (point.damping - vanishing) / beam,
                  (point.damping_paper - point.damping) / beam};
  return point;
}

/// Cases of one aspect ratio march together.
void run_group(const std::vector<DampingCase>& cases, const std::vector<std::size_t>& members,
               const DampingOptions& options, std::vector<DampingPoint>& points) {
  struct Started {
    std::size_t index;
    Plan plan;
    std::size_t first_release, releases;
  };
  std::vector<Started> started;
  std::vector<dem::Release<2>> all;
  for (const std::size_t i : members) {
    try {
      const Plan plan = plan_of(cases[i]);
      const std::vector<dem::Release<2>> own = releases_of(cases[i], plan);
      started.push_back({i, plan, all.size(), own.size()});
      all.insert(all.end(), own.begin(), own.end());
    } catch (const std::runtime_error& error) {
      points[i] = unmeasured(cases[i], error.what());
    }
  }
  dem::ReleaseOptions release_options;
  release_options.form = cases[members[0]].form;
  const auto records = dem::ring_down(all, release_options);
  for (const Started& s : started) {
    const double length = dem::fiber_length(s.plan.fiber);
    const dem::ReleaseRecord<2>& released = records[s.first_release + 1];
    try {
      Marches marches{tip_history(records[s.first_release], length),
                      {},
                      tip_history(released, length),
                      released.time_step,
                      released.steps};
      if (s.releases == 3) marches.loaded = tip_history(records[s.first_release + 2], length);
      points[s.index] = measured(cases[s.index], s.plan, marches, options);
    } catch (const std::runtime_error& error) {
      points[s.index] = unmeasured(cases[s.index], error.what());
    }
    options.advance();
  }
}

void check(const DampingCase& asked) {
  dem::check(damped_fiber(asked));
  if (!(asked.load > 0 && asked.load <= 10)) {
    throw InputError(
        fmt::format("load = {} is not allowed: it must be greater than 0 and at most 10", asked.load));
  }
  if (!(asked.bond_damping > 0)) {
    throw InputError(
        fmt::format("bond_damping = {} is not allowed: without damping there is no decay to measure",
                    asked.bond_damping));
  }
  if (asked.peaks.first < 0 || asked.peaks.last <= asked.peaks.first) {
    throw InputError(fmt::format("peaks = {}..{} is not allowed: give at least two, the first 0 or more",
                                 asked.peaks.first, asked.peaks.last));
  }
}

}  // namespace

dem::Fiber damped_fiber(const DampingCase& asked) {
  dem::Fiber fiber = nominal_fiber(asked.aspect_ratio, asked.poisson_ratio, asked.bond);
  fiber.material = dem::isotropic_material(asked.youngs_modulus, asked.poisson_ratio, fiber.material.density);
  fiber.dashpots = asked.dashpots;
  if (asked.dashpots == dem::DashpotLaw::retardation_time) {
    fiber.retardation_time = asked.bond_damping * dem::bond_time_step(fiber);
  } else {
    fiber.bond_damping = asked.bond_damping;
  }
  return fiber;
}

double equation_20(int aspect_ratio, double bond_damping) {
  return kPaperA * std::exp(-kPaperB * aspect_ratio) * bond_damping;
}

std::vector<DampingPoint> damping_points(const std::vector<DampingCase>& cases,
                                         const DampingOptions& options) {
  for (const DampingCase& asked : cases) check(asked);
  // longest chains first, so that the last thread is not left with them
  std::map<std::pair<int, dem::BondForm>, std::vector<std::size_t>, std::greater<>> groups;
  for (std::size_t i = 0; i < cases.size(); ++i) groups[{cases[i].aspect_ratio, cases[i].form}].push_back(i);
  std::vector<std::vector<std::size_t>> work;
  for (const auto& [kind, members] : groups) work.push_back(members);
  std::vector<DampingPoint> points(cases.size());
  dem::parallel_for(work.size(), options.jobs,
                    [&](std::size_t i) { run_group(cases, work[i], options, points); });
  return points;
}

}  // namespace fiberchain::compare
