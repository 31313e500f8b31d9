#pragma once

#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// Overlap over the smaller radius of single spheres of a scene, or of one and a wall, that meet head on at
/// this speed [m/s] without damping: the largest of all pairs of kinds; 0 without speed. The fiber behind a
/// sphere that it hits with its end presses deeper.
double expected_impact_overlap(const PackingScene& scene, double speed);

}  // namespace fiberchain::dem
