#include "compare/friction/case.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "compare/damping/case.hpp"
#include "compare/friction/law.hpp"
#include "compare/measure/lane_blocks.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/stopping.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::compare {
namespace {

constexpr double periods_beyond_last_peak = 0.9;  // friction and amplitude shift the last peak

DampingCase without_friction(const RollingCase& asked, double bond_damping) {
  return {
      .aspect_ratio = asked.aspect_ratio, .poisson_ratio = asked.poisson_ratio, .bond_damping = bond_damping};
}

RollingPoint unmeasured(const RollingCase& asked, std::string why) {
  return {asked, nan, nan, nan, nan, nan, nan, nan, {}, nan, nan, std::move(why)};
}

reference::ChainMode first_mode(const RollingCase& asked, double bond_damping) {
  return reference::first_bending_mode(linear_chain_of(without_friction(asked, bond_damping)));
}

double mean_amplitude(const std::vector<Peak>& peaks, PeakRange range) {
  double sum = 0;
  for (int j = range.first; j <= range.last; ++j) sum += peaks[j].value;
  return sum / (range.last - range.first + 1);
}

RollingPoint measured(const RollingCase& asked, const reference::ChainMode& mode,
                      const dem::ReleaseRecord<2>& record) {
  RollingPoint point = unmeasured(asked, "measured");
  const dem::Fiber fiber = rolling_fiber(asked);
  point.without = mode.damping;
  point.as_bond = first_mode(asked, asked.bond_damping + asked.rolling_friction).damping;
  point.time_step = record.time_step;
  point.steps = record.steps;
  point.peaks = positive_peaks(tip_history(record, dem::fiber_length(fiber)));
  const int first = asked.peaks.first, last = asked.peaks.last;
  const Damping all = damping_from_peaks(point.peaks, asked.peaks);
  point.damping = all.ratio;
  point.half_width = all.half_width;
  point.first = damping_from_peaks(point.peaks, {first, first + 1}).ratio;
  point.last = damping_from_peaks(point.peaks, {last - 1, last}).ratio;
  point.peaks.resize(last + 1);
  point.weak = point.without + asked.rolling_friction * mean_amplitude(point.peaks, asked.peaks) *
                                   small_friction_damping(fiber, mode);
  return point;
}

/// Cases that march side by side.
void run_block(const std::vector<RollingCase>& cases, const std::vector<std::size_t>& members,
               const RollingOptions& options, std::vector<RollingPoint>& points) {
  const RollingCase& common = cases[members[0]];
  const reference::ChainMode mode = first_mode(common, common.bond_damping);
  // a release from the mode is under way already: its peak 0 comes later
  const double periods = common.peaks.last + (common.amplitude ? 1 : 0) + periods_beyond_last_peak;
  const auto failed = [&](std::size_t i, const std::exception& error) {
    points[i] = unmeasured(cases[i], error.what());
  };
  try {
    if (!mode.oscillates) throw InputError("the first mode is overdamped: there is no vibration");
    std::vector<dem::Release<2>> releases;
    for (const std::size_t i : members) {
      const RollingCase& c = cases[i];
      releases.push_back(c.amplitude ? mode_release(rolling_fiber(c), mode, *c.amplitude, periods)
                                     : static_release(rolling_fiber(c), mode, c.load, periods));
    }
    dem::ReleaseOptions march;
    march.rolling = common.law;
    march.step_ratio = common.step_ratio;
    const auto records = dem::ring_down(releases, march);
    for (std::size_t k = 0; k < members.size(); ++k) {
      try {
        points[members[k]] = measured(cases[members[k]], mode, records[k]);
      } catch (const std::runtime_error& error) {
        failed(members[k], error);
      }
    }
  } catch (const std::runtime_error& error) {
    for (const std::size_t i : members) failed(i, error);
  }
  for (std::size_t k = 0; k < members.size(); ++k) options.advance();
}

/// The law that acts: without friction there is none.
dem::Rolling acting_law(const RollingCase& c) { return c.rolling_friction > 0 ? c.law : dem::Rolling::none; }

/// What the motion follows from; what is measured of it follows from the peaks, too.
auto motion_of(const RollingCase& c) {
  return std::tuple(c.aspect_ratio, 1 / c.step_ratio.value_or(1), acting_law(c), c.bond_damping,
                    c.poisson_ratio, c.peaks.last, c.amplitude, c.amplitude ? 0 : c.load, c.rolling_friction,
                    c.peaks.first);
}

/// Of each case the first whose row is the same but for what was asked.
std::vector<std::size_t> first_alike(const std::vector<RollingCase>& cases) {
  std::map<decltype(motion_of(cases[0])), std::size_t> found;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    first.push_back(found.try_emplace(motion_of(cases[i]), i).first->second);
  }
  return first;
}

/// Blocks of cases with the same step, long marches first. Only the first of those that are alike.
std::vector<std::vector<std::size_t>> blocks_of(const std::vector<RollingCase>& cases,
                                                const std::vector<std::size_t>& first) {
  using Kind = std::tuple<int, double, dem::Rolling, bool, double, double, int>;
  std::vector<std::optional<Kind>> kinds(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const RollingCase& c = cases[i];
    if (first[i] != i) continue;
    kinds[i] = {c.aspect_ratio, 1 / c.step_ratio.value_or(1),
                acting_law(c),  c.amplitude.has_value(),
                c.bond_damping, c.poisson_ratio,
                c.peaks.last};
  }
  return lane_blocks(kinds);
}

void check(const RollingCase& asked) {
  dem::check(rolling_fiber(asked));
  if (!(asked.load > 0 && asked.load <= 10)) {
    throw InputError(
        fmt::format("load = {} is not allowed: it must be greater than 0 and at most 10", asked.load));
  }
  if (asked.amplitude && !(*asked.amplitude > 0 && *asked.amplitude <= 0.5)) {
    throw InputError(fmt::format("amplitude = {} is not allowed: it must be greater than 0 and at most 0.5",
                                 *asked.amplitude));
  }
  if (asked.law == dem::Rolling::none)
    throw InputError("law = none is not allowed: give a law of rolling friction");
  if (asked.peaks.first < 0 || asked.peaks.last <= asked.peaks.first) {
    throw InputError(fmt::format("peaks = {}..{} is not allowed: give at least two, the first 0 or more",
                                 asked.peaks.first, asked.peaks.last));
  }
  const dem::Fiber fiber = rolling_fiber(asked);
  const double limit =
      dem::stable_release_step(fiber, dem::Integrator::leapfrog) / dem::bond_time_step(fiber);
  if (asked.step_ratio && !(*asked.step_ratio > 0 && *asked.step_ratio < limit)) {
    throw InputError(
        fmt::format("step_ratio = {} is not allowed: it must be greater than 0 and below the largest stable "
                    "step of this chain, {:.4f} t_b",
                    *asked.step_ratio, limit));
  }
}

}  // namespace

dem::Fiber rolling_fiber(const RollingCase& asked) {
  dem::Fiber fiber = damped_fiber(without_friction(asked, asked.bond_damping));
  fiber.rolling_friction = asked.rolling_friction;
  return fiber;
}

std::vector<RollingPoint> rolling_points(const std::vector<RollingCase>& cases,
                                         const RollingOptions& options) {
  for (const RollingCase& asked : cases) check(asked);
  const std::vector<std::size_t> first = first_alike(cases);
  const auto blocks = blocks_of(cases, first);
  std::vector<RollingPoint> points;
  for (const RollingCase& asked : cases) points.push_back(unmeasured(asked, std::string(not_begun)));
  options.jobs.run(blocks.size(), [&](std::size_t i) {
    if (!options.stopped()) run_block(cases, blocks[i], options, points);
  });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (first[i] == i) continue;
    points[i] = points[first[i]];
    points[i].asked = cases[i];
    options.advance();
  }
  return points;
}

}  // namespace fiberchain::compare
