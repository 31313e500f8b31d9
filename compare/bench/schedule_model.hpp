#pragma once

#include <vector>

#include "dem/assembly/assembly.hpp"

// A model of how threads share a step: the parts with what they cost and wait for, taken as
// dem/parallel/wavefront_schedule.hpp takes them. It says what more threads than there are would give.
namespace fiberchain::compare {

/// A step of an assembly as one thread does it.
struct StepWork {
  std::vector<dem::PartTimes> parts;  ///< [s a step]
  double search;                      ///< lists of neighbors, shared evenly [s a step]
  double serial;                      ///< what one thread does alone [s a step]
};

/// What two threads cost beside their work.
struct SharingCosts {
  double slowdown;  ///< time of the same work on two threads over that on one
  double meeting;   ///< of starting and ending the loops [s a step]
};

/// Time of a step on so many threads [s]; on one the work itself.
double modeled_step(const StepWork& work, int threads, const SharingCosts& costs);

}  // namespace fiberchain::compare
