#pragma once

#include <string>
#include <vector>

#include "compare/stability/case.hpp"

// Schemes without a stable step of their own, leapfrog-stiff: whether small motions grow at steps far beyond
// t_b, by modes and by runs.
namespace fiberchain::compare {

/// A chain marched by such a scheme, at steps in units of t_b.
struct GrowthCase {
  StabilityCase chain;
  std::vector<double> step_ratios{10, 100, 1000};
};

/// What happens at one step.
struct Growth {
  double step_ratio;  ///< dt/t_b
  double modes;       ///< largest |z| of a mode of the chain
  double measured;    ///< growth of a run's speeds a step: peaks of its last quarter over those of its second
  double swell;       ///< largest speed of the run over that of its start
  std::int64_t steps;  ///< of the run

  bool grows() const;
};

struct GrowthPoint {
  GrowthCase asked;
  std::vector<Growth> at;  ///< the steps asked for
  std::string status;
};

/// Beyond this a run has grown. A mode's speed swells to sqrt(4 beta/(4 beta - 1)), 2.4 times that of its
/// start at beta = 0.3; from spins, which weigh less than velocities, to velocities it is up to sqrt(10)
/// times that.
inline constexpr double swollen = 10;

/// Steps of a run, unless its motion dies before. What grows by 6e-4 a step is found: with 350 times in all,
/// a thousandth part of the start's motion swells to a third of it.
inline constexpr int growth_steps = 10000;

/// How far `measured` may be from `modes` after so many steps: other motions than the slowest to die take
/// part in both quarters, each at most 1e-3 of the other.
double growth_margin(std::int64_t steps);

/// Every case in the order given, its steps side by side in lanes. Throws InputError or dem::InvalidInput for
/// a case out of range: schemes with a stable step, more than 200 bonds (dense modes).
std::vector<GrowthPoint> growth_points(const std::vector<GrowthCase>& cases,
                                       const StabilityOptions& options = {});

}  // namespace fiberchain::compare
