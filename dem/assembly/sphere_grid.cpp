#include "dem/assembly/sphere_grid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/errors.hpp"

namespace fiberchain::dem {

namespace {

Cells cells_for(const Box& box, const Vec<double, 3>& period, double reach, std::int64_t expected) {
  for (const double p : period.c) {
    if (p > 0 && p < 2 * reach) {
      throw InvalidInput(
          fmt::format("period = {} m is not allowed: it must be at least {} m, twice the largest distance "
                      "of two spheres that touch",
                      p, 2 * reach));
    }
  }
  return {box, period, reach, 64 + 8.0 * static_cast<double>(expected)};
}

}  // namespace

SphereGrid::SphereGrid(const Box& box, const Vec<double, 3>& period, double largest_radius, double gap,
                       std::int64_t expected)
    : period_(period), gap_(gap), cells_(cells_for(box, period, 2 * largest_radius + gap, expected)) {}

void SphereGrid::add(const Vec<double, 3>& center, double radius) {
  cells_.add(center);
  spheres_.position.push_back(center);
  spheres_.radius.push_back(radius);
}

Vec<double, 3> SphereGrid::nearest(const Vec<double, 3>& a, const Vec<double, 3>& b) const {
  Vec<double, 3> r = b - a;
  for (int k = 0; k < 3; ++k) {
    if (period_[k] > 0) r[k] -= period_[k] * std::round(r[k] / period_[k]);
  }
  return r;
}

bool SphereGrid::free(const Vec<double, 3>& center, double radius) const {
  return cells_.around(center, [&](std::int32_t n) {
    const Vec<double, 3> r = nearest(center, spheres_.position[n]);
    const double reach = radius + spheres_.radius[n] + gap_;
    return !(dot(r, r) < reach * reach);
  });
}

}  // namespace fiberchain::dem
