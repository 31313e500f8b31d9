#pragma once

#include <cstdint>
#include <memory>
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

/// All spheres by cells, to ask for pairs. The spheres must stay where they are.
class CloseSearch {
 public:
  /// `kernel` is that of the scene's contacts (periodic or not). Throws InvalidInput where a periodic side is shorter than
  /// three cells of 2 R + skin, and for positions that are not finite.
  CloseSearch(const SphereSet& spheres, double skin, const ContactKernel& kernel);
  ~CloseSearch();
  CloseSearch(const CloseSearch&) = delete;
  CloseSearch& operator=(const CloseSearch&) = delete;

  /// Every pair of spheres of different fibers, or of one that are no neighbors along it, with a gap below `skin` [m],
  /// whose first number is one of begin ... end - 1, by rising first and second number.
  std::vector<ClosePair> pairs(std::int32_t begin, std::int32_t end) const;

 private:
  struct Inside;
  std::unique_ptr<const Inside> inside_;
};

}  // namespace fiberchain::dem
