#pragma once

#include "dem/assembly/assembly.hpp"

namespace fiberchain::compare {

/// Velocities and spins of all spheres become 0; contacts keep their springs, walls and grips go on. What is
/// looked for at rest is found sooner so.
void stop_motion(dem::Assembly& assembly);

}  // namespace fiberchain::compare
