#include "dem/insertion/insertion_grid.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::dem {

InsertionGrid::InsertionGrid(const Box& box, const Vec<double, 3>& period, double largest_radius, double gap,
                             std::int64_t expected)
    : box_(box),
      period_(period),
      periods_(periodic_box(period)),
      largest_radius_(largest_radius),
      gap_(gap),
      most_cells_(64 + 8.0 * static_cast<double>(expected)) {
  check_minimum_image(period, 2 * largest_radius + gap);
}

InsertionGrid::Class& InsertionGrid::class_of(double radius) {
  const int k = size_class(radius, largest_radius_);
  if (!classes_[k]) {
    const double largest = std::ldexp(largest_radius_, -k);
    const CellGeometry cells(box_, period_, 2 * largest + gap_, most_cells_);
    classes_[k].emplace(Class{largest, LinkedCellList(cells), {}});
  }
  return *classes_[k];
}

void InsertionGrid::add(const Vec<double, 3>& center, double radius) {
  Class& own = class_of(radius);
  own.cells.add(center);
  own.spheres.position.push_back(center);
  own.spheres.radius.push_back(radius);
}

Vec<double, 3> InsertionGrid::nearest(const Vec<double, 3>& a, const Vec<double, 3>& b) const {
  return nearest_image(periods_, b - a);
}

bool InsertionGrid::free(const Vec<double, 3>& center, double radius) const {
  return std::ranges::all_of(classes_, [&](const std::optional<Class>& size) {
    if (!size) return true;
    const auto is_apart = [&](std::int32_t n) {
      const Vec<double, 3> r = nearest(center, size->spheres.position[n]);
      const double reach = radius + size->spheres.radius[n] + gap_;
      return !(dot(r, r) < reach * reach);
    };
    return radius <= size->largest ? size->cells.around(center, is_apart)
                                   : size->cells.within(center, radius + size->largest + gap_, is_apart);
  });
}

}  // namespace fiberchain::dem
