#include "compare/bench/turns.hpp"

#include <algorithm>

#include "dem/run/processor_time.hpp"

namespace fiberchain::compare {
namespace {

double middle_of(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

}  // namespace

TurnPlan turn_plan(const BenchOptions& options) {
  return options.quick ? TurnPlan{6000, 50, 7} : TurnPlan{15000, 200, 31};
}

std::vector<TurnTime> march_in_turns(const std::vector<std::unique_ptr<dem::Assembly>>& packings,
                                     const TurnPlan& plan) {
  std::vector<std::vector<double>> windows(packings.size());  // [s]
  for (int round = 0; round < plan.rounds; ++round) {
    for (std::size_t n = 0; n < packings.size(); ++n) {
      const dem::ProcessorTimer timer(windows[n].emplace_back(0));
      packings[n]->march(plan.window);
    }
  }
  std::vector<TurnTime> times;
  for (std::size_t n = 0; n < packings.size(); ++n) {
    std::vector<double> ratios;
    for (int round = 0; round < plan.rounds; ++round) ratios.push_back(windows[n][round] / windows[0][round]);
    const auto sphere_steps = static_cast<double>(packings[n]->spheres() * plan.window);
    times.push_back({1e9 * middle_of(windows[n]) / sphere_steps, middle_of(ratios)});
  }
  return times;
}

}  // namespace fiberchain::compare
