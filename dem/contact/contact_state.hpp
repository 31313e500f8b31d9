#pragma once

#include <cstdint>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A touching pair: two spheres, or a sphere and a wall.
struct ContactState {
  std::int64_t first, second;  ///< sphere numbers; second < 0: wall -1 - second
  double overlap;              ///< [m]
  Vec<double, 3> point;        ///< of contact [m]
  Vec<double, 3> force;        ///< on the first sphere [N]
};

}  // namespace fiberchain::dem
