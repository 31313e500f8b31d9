#pragma once

#include <cstdint>
#include <vector>

#include "dem/math/vec.hpp"

// Which spheres are close: a cell grid, in whose order the spheres are then worked on.
namespace fiberchain::dem {

/// Spheres by number.
struct SphereSet {
  std::vector<Vec<double, 3>> position;  ///< [m]
  std::vector<double> radius;            ///< [m]
  std::vector<std::int32_t> fiber;       ///< neighbors along a fiber have consecutive numbers and do not contact
  Vec<double, 3> period;                 ///< [m]; 0: not periodic
};

struct ClosePair {
  std::int32_t first, second;  ///< slots, first < second
};

/// Spheres in the order of their cells. A stripe is a run of slots, worked on by one thread at a time.
struct CellOrder {
  std::vector<std::int32_t> sphere_of_slot, slot_of_sphere;
  std::vector<std::int32_t> stripe_begin;            ///< stripes + 1 slots
  std::vector<std::vector<ClosePair>> pairs;         ///< of each stripe, by rising first and second slot
};

/// Orders the spheres and lists every pair of different fibers, or of spheres of one that are no neighbors along it, with a
/// gap below `skin` [m]. Every slot's pairs are those with later slots. Throws InvalidInput where a periodic side is shorter
/// than three cells of 2 R + skin, and for positions that are not finite.
CellOrder close_pairs(const SphereSet& spheres, double skin, int stripes, int threads);

}  // namespace fiberchain::dem
