#include "compare/damping/case.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "compare/damping/references.hpp"
#include "compare/fit/law.hpp"
#include "compare/measure/first_mode_damping.hpp"
#include "compare/measure/lane_blocks.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/stopping.hpp"
#include "dem/model/errors.hpp"
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

/// A case that can be measured, its releases and what they did.
struct Prepared {
  Plan plan;
  std::vector<dem::Release<2>> releases;
  std::vector<dem::ReleaseRecord<2>> records;

  bool marched() const {
    return std::ranges::none_of(records, [](const auto& record) { return record.samples.empty(); });
  }
};
using AllPrepared = std::vector<std::optional<Prepared>>;

/// A release of a case.
struct Release {
  std::size_t index, which;
};

/// What marches side by side: equal length and form, equal steps between samples and as many of them.
using BlockKey = std::tuple<int, dem::BondForm, int, double>;

dem::ReleaseOptions options_of(const DampingCase& asked) {
  dem::ReleaseOptions options;
  options.form = asked.form;
  return options;
}

BlockKey key_of(const DampingCase& asked, const dem::Release<2>& release) {
  const dem::ReleaseOptions options = options_of(asked);
  const double steps = release.period / (options.samples_per_period * dem::release_step(release, options));
  return {asked.aspect_ratio, asked.form, static_cast<int>(std::lround(steps)), release.periods};
}

AllPrepared prepared(const std::vector<DampingCase>& cases, const DampingOptions& options,
                     DampingPoints& points) {
  AllPrepared all(cases.size());
  options.jobs.run(cases.size(), [&](std::size_t i) {
    try {
      const Plan plan = plan_of(cases[i]);
      all[i] = Prepared{plan, releases_of(cases[i], plan), {}};
      all[i]->records.resize(all[i]->releases.size());
    } catch (const std::runtime_error& error) {
      points[i] = unmeasured(cases[i], error.what());
      options.advance();
    }
  });
  return all;
}

/// All releases, in lanes.
void march(const std::vector<DampingCase>& cases, const DampingOptions& options, AllPrepared& all) {
  std::vector<Release> releases;
  std::vector<std::optional<BlockKey>> keys;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; all[i] && k < all[i]->releases.size(); ++k) {
      releases.push_back({i, k});
      keys.emplace_back(key_of(cases[i], all[i]->releases[k]));
    }
  }
  const auto blocks = lane_blocks(keys);
  options.jobs.run(blocks.size(), [&](std::size_t b) {
    if (options.stopped()) return;
    std::vector<dem::Release<2>> together;
    for (const std::size_t n : blocks[b])
      together.push_back(all[releases[n].index]->releases[releases[n].which]);
    auto records = dem::ring_down(together, options_of(cases[releases[blocks[b].front()].index]));
    for (std::size_t lane = 0; lane < blocks[b].size(); ++lane) {
      const Release& release = releases[blocks[b][lane]];
      all[release.index]->records[release.which] = std::move(records[lane]);
    }
  });
}

DampingPoint point_of(const DampingCase& asked, const Prepared& p, const DampingOptions& options) {
  try {
    const double length = dem::fiber_length(p.plan.fiber);
    const dem::ReleaseRecord<2>& released = p.records[1];
    Marches marches{tip_history(p.records[0], length),
                    {},
                    tip_history(released, length),
                    released.time_step,
                    released.steps};
    if (p.records.size() == 3) marches.loaded = tip_history(p.records[2], length);
    return measured(asked, p.plan, marches, options);
  } catch (const std::runtime_error& error) {
    return unmeasured(asked, error.what());
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
  DampingPoints points;
  for (const DampingCase& asked : cases) points.push_back(unmeasured(asked, std::string(not_begun)));
  AllPrepared all = prepared(cases, options, points);
  march(cases, options, all);
  std::vector<double> costs;  // of the damped Elastica
  for (const auto& p : all) costs.push_back(p ? p->plan.clean.periods() : 0);
  options.jobs.run_dearest_first(costs, [&](std::size_t i) {
    if (!all[i] || !all[i]->marched() || options.stopped()) return;
    points[i] = point_of(cases[i], *all[i], options);
    options.advance();
  });
  return points;
}

}  // namespace fiberchain::compare
