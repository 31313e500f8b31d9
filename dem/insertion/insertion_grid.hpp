#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dem/contact/linked_cell_list.hpp"
#include "dem/contact/periodic_box.hpp"
#include "dem/contact/size_classes.hpp"

namespace fiberchain::dem {

/// Spheres that stand somewhere.
struct PlacedSpheres {
  std::vector<Vec<double, 3>> position;  ///< of centers [m]
  std::vector<double> radius;            ///< [m]
};

/// Spheres by cells, each class of size in its own, to ask whether one more fits.
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
  struct Class {
    double largest;  ///< radius that may be of it [m]
    LinkedCellList cells;
    PlacedSpheres spheres;
  };
  Class& class_of(double radius);

  Box box_;
  Vec<double, 3> period_;
  PeriodicBox periods_;
  double largest_radius_, gap_, most_cells_;
  std::optional<Class> classes_[most_size_classes];  ///< those that occur
};

}  // namespace fiberchain::dem
