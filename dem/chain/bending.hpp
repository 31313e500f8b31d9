#pragma once

#include "dem/chain/chain.hpp"

namespace fiberchain::dem {

/// Angle [rad] between two vectors, accurate at 0 and pi too.
double angle_between(const Vec<double, 3>& a, const Vec<double, 3>& b);

/// Angle [rad] of bond i: between the axes that its two spheres' orientations have, 0 at rest (also of a
/// curved chain: each orientation is taken with the bond's rest offset). This is the bending theta_b of the
/// bond law; twist is not in it.
double bending_angle(const Chain<3>& chain, const Poses<3>& poses, int bond);

/// Angle [rad] between the bonds before and after sphere i, 0 < i < aspect_ratio: by positions alone.
double turning_angle(const Poses<3>& poses, int sphere);

}  // namespace fiberchain::dem
