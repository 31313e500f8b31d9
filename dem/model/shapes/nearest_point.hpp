#pragma once

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// Nearest point of a wall, seen from a point in the domain. A template on the number type: a double, or as
/// many points side by side as a Real has lanes.
template <class Real>
struct NearestPoint {
  Vec<Real, 3> direction;  ///< unit vector to the wall
  Real distance;           ///< [m]; negative behind the wall
};

}  // namespace fiberchain::dem
