#pragma once

#include <cstdint>
#include <vector>

#include "dem/contact/linked_cell_list.hpp"
#include "dem/contact/periodic_box.hpp"

namespace fiberchain::dem {

/// Spheres that stand somewhere.
struct PlacedSpheres {
  std::vector<Vec<double, 3>> position;  ///< of centers [m]
  std::vector<double> radius;            ///< [m]
};

/// Spheres by cells, to ask whether one more fits.
class InsertionGrid {
 public:
  /// For spheres of at most the reach, that are added in or near the box, about `expected` of them. Periodic
  /// along axes whose `period` is above 0. Throws InvalidInput when a period is less than twice the largest
  /// distance that is not free.
  InsertionGrid(const Box& box, const Vec<double, 3>& period, double largest_radius, double gap,
                std::int64_t expected);

  void add(const Vec<double, 3>& center, double radius);

  /// Whether no sphere is nearer than the radii and the gap, periodic images included.
  bool free(const Vec<double, 3>& center, double radius) const;

  /// From a to the nearest image of b.
  Vec<double, 3> nearest(const Vec<double, 3>& a, const Vec<double, 3>& b) const;

 private:
  PeriodicBox periods_;
  double gap_;
  LinkedCellList cells_;
  PlacedSpheres spheres_;
};

}  // namespace fiberchain::dem
