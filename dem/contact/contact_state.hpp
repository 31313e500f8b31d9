#pragma once

#include "dem/contact/contact_key.hpp"
#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A touching pair: two spheres, or a sphere and a wall.
struct ContactState {
  ContactKey key;         ///< spheres by their numbers, walls as facets
  double overlap;         ///< [m]
  Vec<double, 3> point;   ///< of contact [m]
  Vec<double, 3> normal;  ///< from the first sphere to the other body
  Vec<double, 3> force;   ///< on the first sphere [N]
};

}  // namespace fiberchain::dem
