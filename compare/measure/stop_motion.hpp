#pragma once

#include "dem/assembly/assembly.hpp"

namespace fiberchain::compare {

/// Velocities and spins of all spheres become 0; contacts keep their springs, walls and grips go on. What is
/// looked for at rest is found sooner so.
void stop_motion(dem::Assembly& assembly);

/// Stops it when the motion of group 0 has passed its largest energy; `last` is what this gave at the look
/// before, 0 at the first.
double stop_past_peak(dem::Assembly& assembly, double last);

}  // namespace fiberchain::compare
