#pragma once

#include <memory>
#include <vector>

#include "compare/bench/problems.hpp"
#include "dem/assembly/assembly.hpp"

// Packings that march beside each other in turns, so that what else the machine does slows all of them alike.
namespace fiberchain::compare {

/// How long.
struct TurnPlan {
  std::int64_t fall, window;  ///< steps before, and of a turn
  int rounds;
};

TurnPlan turn_plan(const BenchOptions& options);

/// Of one packing.
struct TurnTime {
  double sphere_step;  ///< median of its windows [ns]
  double ratio;        ///< median of its windows' ratios to those of the first packing beside them
};

/// Marches each in every round by a window, timed by the processor.
std::vector<TurnTime> march_in_turns(const std::vector<std::unique_ptr<dem::Assembly>>& packings,
                                     const TurnPlan& plan);

}  // namespace fiberchain::compare
