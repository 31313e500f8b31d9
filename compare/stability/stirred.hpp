#pragma once

#include <functional>
#include <vector>

#include "compare/stability/run.hpp"

namespace fiberchain::compare {

/// A time step [s] and how fast its chain is stirred: bond lengths and radians a second.
struct StirredLane {
  double time_step, rate;
};

/// Physics of the run in the plane.
dem::Physics planar_physics(const StabilityRun& run);

/// Steps that march side by side in one block.
int lanes_of_block(const StabilityRun& run);

/// Marches up to lanes_of_block() lanes of the straight fiber from random velocities, the same of each but
/// for their rate. After every `between` steps hands speeds (root mean square over the spheres of velocity
/// and l times spin) over those of the start to `go_on`, which says whether to. Throws dem::InvalidInput.
void march_stirred(const StabilityRun& run, const std::vector<StirredLane>& lanes, int steps, int between,
                   const std::function<bool(const std::vector<double>& speeds)>& go_on);

}  // namespace fiberchain::compare
