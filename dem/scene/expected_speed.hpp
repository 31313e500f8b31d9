#pragma once

#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// Speed that fibers of a scene have at their start or may come to by falling from its top to its bottom, no
/// faster than its duration allows or a fluid at rest, and by a flow [m/s]. Of walls the turning of those
/// that meet fibers at random is in it, pushes are not.
double expected_speed(const PackingScene& scene);

}  // namespace fiberchain::dem
