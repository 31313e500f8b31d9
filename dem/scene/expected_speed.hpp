#pragma once

#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// Speed that fibers of a scene have at their start or may come to by falling from its top to its bottom, no
/// faster than its duration allows or a fluid at rest, and by a flow [m/s]. Pushes of walls are not in it.
double expected_speed(const PackingScene& scene);

}  // namespace fiberchain::dem
