#include "compare/stability/run.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/stability/stirred.hpp"

namespace fiberchain::compare {
namespace {

constexpr int together = 8;  // steps tried at once

/// Marches the lanes of one block; stops when all have grown.
std::vector<bool> block_grows(const StabilityRun& run, const std::vector<StirredLane>& lanes, int steps) {
  std::vector<bool> grew(lanes.size(), false);
  march_stirred(run, lanes, steps, 500, [&](const std::vector<double>& speeds) {
    for (std::size_t i = 0; i < grew.size(); ++i) grew[i] = grew[i] || !(speeds[i] < grown);
    return !std::ranges::all_of(grew, std::identity{});
  });
  return grew;
}

/// Narrows to the last that was stable before the first that grew. If the lowest grew that was stable before,
/// in fewer steps, the lower end moves down by `retreat`.
void narrow(MeasuredLimit& limit, const std::vector<double>& tried, const std::vector<bool>& grew,
            double retreat) {
  const auto first = static_cast<std::size_t>(std::ranges::find(grew, true) - grew.begin());
  limit.stable = first > 0 ? tried[first - 1] : tried[0] / retreat;
  if (first < tried.size()) limit.unstable = tried[first];
  limit.ordered = limit.ordered && std::ranges::is_sorted(grew);
}

}  // namespace

std::vector<bool> motion_grows(const StabilityRun& run, const std::vector<double>& time_steps, int steps) {
  const auto width = static_cast<std::size_t>(lanes_of_block(run));
  const double rate = 1e-9 / dem::bond_time_step(run.fiber);
  std::vector<bool> all;
  for (std::size_t first = 0; first < time_steps.size(); first += width) {
    std::vector<StirredLane> part;
    for (std::size_t i = first; i < std::min(first + width, time_steps.size()); ++i)
      part.push_back({time_steps[i], rate});
    const auto grew = block_grows(run, part, steps);
    all.insert(all.end(), grew.begin(), grew.end());
  }
  return all;
}

int steps_to_grow(const StabilityRun& run, double excess) {
  const bool lagged = run.scheme == dem::Integrator::leapfrog;
  const double sensitivity = lagged ? 2 : std::min(2.0, 0.8 / std::max(run.fiber.bond_damping, 1e-9));
  // what grows is at least a part 1/sqrt(unknowns) of a random motion
  const double unknowns = 6.0 * (run.fiber.aspect_ratio + 1);
  return static_cast<int>(std::log(grown * std::sqrt(unknowns)) / std::log1p(sensitivity * excess)) + 100;
}

MeasuredLimit measured_limit(const StabilityRun& run, double width) {
  dem::check(run.fiber);
  MeasuredLimit limit{0, 2.5 * dem::bond_time_step(run.fiber), 0, true};
  bool verified = false;  // that the lower end is stable, for as many steps as the width asks for
  const auto look = [&](double lowest, double ratio) {
    std::vector<double> tried;
    for (int i = 0; i < together; ++i) tried.push_back(lowest * std::pow(ratio, i));
    const double excess = std::clamp((ratio - 1) / 2, width / 2, 0.1);
    const int steps = steps_to_grow(run, excess);
    const std::vector<bool> grew = motion_grows(run, tried, steps);
    narrow(limit, tried, grew, std::max(ratio, 1 + width));
    limit.steps += steps * static_cast<double>(tried.size());
    verified = excess == width / 2 && !grew[0];
    return !grew[0];
  };
  while (!look(limit.unstable / std::ldexp(1.0, together), 2.0)) continue;
  while (!verified || limit.unstable > (1 + width) * limit.stable) {
    look(limit.stable, std::pow(limit.unstable / limit.stable, 1.0 / together));
  }
  return limit;
}

}  // namespace fiberchain::compare
