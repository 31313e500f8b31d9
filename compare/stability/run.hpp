#pragma once

#include <vector>

#include "dem/model/fiber.hpp"
#include "dem/motion/integrator.hpp"
#include "dem/motion/physics.hpp"
#include "reference/amplification.hpp"

// The largest stable step found by running the chain: a tiny random motion of a straight fiber grows or does
// not.
namespace fiberchain::compare {

/// A straight fiber, how it is held and how it is marched.
struct StabilityRun {
  dem::Fiber fiber;
  reference::ChainEnds ends = reference::ChainEnds::clamped_free;
  int dimension = 2;
  dem::BondForm form = dem::BondForm::incremental;
  dem::Integrator scheme = dem::Integrator::leapfrog;
};

/// Beyond this growth of the velocities a motion has grown. A stable one can show growth too: below the
/// undamped limit by a part delta, velocities at half steps swing to (2 delta)^(-1/2) times their start, 700
/// at delta = 1e-6.
inline constexpr double grown = 2e3;

/// For each time step [s] whether random velocities, 1e-9 of a bond length in t_b, grow by `grown` or leave
/// the finite numbers in `steps` steps. Steps run side by side in lanes, by eights whatever the lanes' width.
/// Throws dem::InvalidInput.
std::vector<bool> motion_grows(const StabilityRun& run, const std::vector<double>& time_steps, int steps);

/// Steps in which a motion grows for certain at a time step a part `excess` above the limit. At a root z = -1
/// d|z|/d(ln dt) is at least 2 with lagged dashpots and about 0.8/xi_b with dashpots solved within the step.
int steps_to_grow(const StabilityRun& run, double excess);

struct MeasuredLimit {
  double stable;    ///< largest time step tried that did not grow, with none that did below it [s]
  double unstable;  ///< smallest that grew [s]
  double steps;     ///< time steps marched, all lanes together
  bool ordered;     ///< whether every step tried below `stable` was stable and every one above `unstable` not
};

/// Brackets the limit to `width` of itself: first by octaves down from 2.5 t_b, then by eight equal ratios at
/// a time. Each time its lower end is tried again for more steps: a motion that grows too slowly for the runs
/// before is found out. Knows nothing of the theory but steps_to_grow().
MeasuredLimit measured_limit(const StabilityRun& run, double width = 1.4e-3);

}  // namespace fiberchain::compare
