#pragma once

#include "dem/contact/contact_key.hpp"
#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A touching pair: two spheres, or segments of smooth fibers, or a sphere and a wall.
struct ContactState {
  ContactKey key;         ///< spheres by their numbers, segments by that of their first one, walls as facets
  double overlap;         ///< [m]
  Vec<double, 3> point;   ///< of contact [m]
  Vec<double, 3> normal;  ///< from the first body to the other one
  Vec<double, 3> force;   ///< on the first body [N]
};

}  // namespace fiberchain::dem
