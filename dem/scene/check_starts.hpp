#pragma once

#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// Overlap over the (smaller) radius from which on fibers do not start: contacts would burst.
inline constexpr double deepest_start = 0.5;

/// Fibers of files may touch each other and the walls that are there at time 0, of whatever shape, but not
/// lie in them by `deepest_start` or more. Fibers at random are clear of both by themselves.
/// @throws InvalidInput naming file, line, fiber, sphere and what it lies in
void check_starts(const PackingScene& scene);

}  // namespace fiberchain::dem
