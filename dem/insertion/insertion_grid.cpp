#include "dem/insertion/insertion_grid.hpp"

namespace fiberchain::dem {

namespace {

CellGeometry cells_for(const Box& box, const Vec<double, 3>& period, double reach, std::int64_t expected) {
  check_minimum_image(period, reach);
  return {box, period, reach, 64 + 8.0 * static_cast<double>(expected)};
}

}  // namespace

InsertionGrid::InsertionGrid(const Box& box, const Vec<double, 3>& period, double largest_radius, double gap,
                             std::int64_t expected)
    : periods_(periodic_box(period)),
      gap_(gap),
      cells_(cells_for(box, period, 2 * largest_radius + gap, expected)) {}

void InsertionGrid::add(const Vec<double, 3>& center, double radius) {
  cells_.add(center);
  spheres_.position.push_back(center);
  spheres_.radius.push_back(radius);
}

Vec<double, 3> InsertionGrid::nearest(const Vec<double, 3>& a, const Vec<double, 3>& b) const {
  return nearest_image(periods_, b - a);
}

bool InsertionGrid::free(const Vec<double, 3>& center, double radius) const {
  return cells_.around(center, [&](std::int32_t n) {
    const Vec<double, 3> r = nearest(center, spheres_.position[n]);
    const double reach = radius + spheres_.radius[n] + gap_;
    return !(dot(r, r) < reach * reach);
  });
}

}  // namespace fiberchain::dem
