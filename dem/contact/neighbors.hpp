#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem/contact/view.hpp"
#include "dem/math/vec.hpp"

// Which spheres are close, by a cell grid.
namespace fiberchain::dem {

/// Spheres by number.
struct SphereSet {
  std::span<const Vec<double, 3>> position;  ///< [m]
  std::span<const double> radius;            ///< [m]
  std::span<const std::int32_t> fiber;       ///< neighbors along a fiber have consecutive numbers and do not contact
  Vec<double, 3> period;                     ///< [m]; 0: not periodic
};

struct ClosePair {
  std::int32_t first, second;  ///< sphere numbers, first < second
};

/// Every pair of spheres of different fibers, or of one that are no neighbors along it, with a gap below `skin` [m], by
/// rising first and second number, in the runs of first numbers that `run_begin` (runs + 1 numbers) gives. Throws
/// InvalidInput where a periodic side is shorter than three cells of 2 R + skin, and for positions that are not finite.
/// `kernel` is that of the scene's contacts (periodic or not).
std::vector<std::vector<ClosePair>> close_pairs(const SphereSet& spheres, double skin,
                                                const std::vector<std::int32_t>& run_begin, int threads,
                                                const ContactKernel& kernel);

}  // namespace fiberchain::dem
