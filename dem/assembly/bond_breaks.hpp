#pragma once

#include <cstdint>

#include "dem/math/vec.hpp"
#include "dem/model/bond_failure.hpp"

namespace fiberchain::dem {

/// A bond that broke.
struct BondBreak {
  std::int64_t step;  ///< moment it broke at: it has acted up to there
  double time;        ///< [s]
  int group, fiber;   ///< number of the fiber in its group
  int bond;           ///< from its sphere of this number to the next
  BreakCause cause;
  double stress;         ///< that was the largest part of its strength [Pa]; 0 by hand
  double energy;         ///< that it stored [J]
  Vec<double, 3> place;  ///< of its middle [m]
};

}  // namespace fiberchain::dem
