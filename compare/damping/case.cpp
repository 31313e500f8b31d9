#include "compare/damping/case.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "compare/damping/references.hpp"
#include "compare/fit/law.hpp"
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
constexpr int mode_release_peaks = 4;  // after the release
constexpr int clean_peaks = 6;         // used for fiber_damping after a static release

/// What is marched for one case and how its peaks are counted.
struct Plan {
  dem::Fiber fiber;
  reference::ChainMode mode;
  bool from_mode;   ///< fiber_damping from the first mode
  PeakRange clean;  ///< peaks of fiber_damping, counted in its own release
  double periods;   ///< of the static release
  bool watched;     ///< long enough for mode 2 to go
};

double bond_steps(const dem::Fiber& fiber, const reference::ChainMode& mode, double periods) {
  const dem::Release<2> release{{fiber, {}, {}}, {}, {}, {}, 2 * std::numbers::pi / mode.eigenvalue.imag(),
                                periods};
  return periods * release.period / dem::release_step(release, dem::ReleaseOptions{}) * fiber.aspect_ratio;
}

Plan plan_of(const DampingCase& asked, const DampingOptions& options) {
  Plan plan{damped_fiber(asked), reference::first_bending_mode(linear_chain_of(asked)), false, {}, 0, true};
  plan.from_mode = asked.load <= largest_mode_release_load;
  const int first = first_clean_peak(plan.mode.damping);
  plan.clean =
      plan.from_mode ? PeakRange{0, mode_release_peaks - 1} : PeakRange{first, first + clean_peaks - 1};
  const int last = plan.from_mode ? asked.peaks.last : std::max(asked.peaks.last, plan.clean.last);
  plan.periods = last + 0.7;
  plan.watched = plan.from_mode || bond_steps(plan.fiber, plan.mode, plan.periods) <= options.largest_cost;
  if (!plan.watched) plan.periods = asked.peaks.last + 0.7;
  return plan;
}

/// The marches of one case.
struct Marches {
  TipHistory vanishing, loaded,
      released;  ///< first mode at vanishing load, at the load (or empty), static release
  double time_step, steps;
};

std::vector<dem::Release<2>> releases_of(const DampingCase& asked, const Plan& plan) {
  const double mode_periods = mode_release_peaks + 0.7;
  std::vector<dem::Release<2>> all{mode_release(plan.fiber, plan.mode, vanishing_load / 3, mode_periods),
                                   static_release(plan.fiber, plan.mode, asked.load, plan.periods)};
  if (plan.from_mode) all.push_back(mode_release(plan.fiber, plan.mode, asked.load / 3, mode_periods));
  return all;
}

DampingPoint unmeasured(const DampingCase& asked, std::string why) {
  return {asked, nan, nan, nan, nan, nan,           nan, nan, nan, nan, nan, {nan, nan, nan, nan, nan},
          nan,   nan, {},  nan, 0,   std::move(why)};
}

/// Damping of the part of the motion that the plan calls clean, by both routes.
void measure_clean(DampingPoint& point, const TipHistory& history, PeakRange range) {
  const std::vector<Peak> peaks = positive_peaks(history);
  const Damping found = damping_from_peaks(peaks, range);
  point.damping = found.ratio;
  point.half_width = found.half_width;
  point.frequency = found.frequency;
  point.damping_sine =
      damping_from_sine(history, peaks[range.first].time, peaks[range.last].time, found).ratio;
}

DampingPoint measured(const DampingCase& asked, const Plan& plan, const Marches& marches,
                      const DampingOptions& options) {
  DampingPoint point = unmeasured(asked, plan.watched ? "measured" : "mode 2 outlives the watch");
  const double vanishing =
      damping_from_peaks(positive_peaks(marches.vanishing), {0, mode_release_peaks - 1}).ratio;
  try {
    point.damping_paper = damping_from_peaks(positive_peaks(marches.released), asked.peaks).ratio;
  } catch (const InputError& error) {  // mode 2 can make the first peaks grow
    if (plan.watched) point.status = std::string("measured, but not as the paper: ") + error.what();
  }
  if (plan.watched) measure_clean(point, plan.from_mode ? marches.loaded : marches.released, plan.clean);
  const DampingReferences known =
      damping_references(asked, plan.mode, plan.clean, plan.from_mode, options.elastica && plan.watched);
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
      const Plan plan = plan_of(cases[i], options);
      if (!plan.mode.oscillates) throw InputError("the first mode is overdamped: there is no vibration");
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

int first_clean_peak(double ratio) {
  // (beta_1/beta_2)^4 of mode 1 to begin with, decaying (beta_2/beta_1)^4 times as fast
  constexpr double faster = 39.2738, start = 1 / faster, wanted = 1e-4;
  const double per_period = 2 * std::numbers::pi * ratio * (faster - 1);
  return std::max(static_cast<int>(std::ceil(std::log(start / wanted) / per_period)), 1);
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
