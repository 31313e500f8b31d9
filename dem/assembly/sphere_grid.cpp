#include "dem/assembly/sphere_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem/errors.hpp"

namespace fiberchain::dem {

SphereGrid::SphereGrid(const Box& box, const Vec<double, 3>& period, double largest_radius, double gap,
                       std::int64_t expected)
    : low_(box.low), period_(period), gap_(gap) {
  const double reach = 2 * largest_radius + gap;
  double length[3], volume = 1;
  for (int a = 0; a < 3; ++a) {
    if (period[a] > 0 && period[a] < 2 * reach) {
      throw InvalidInput(
          fmt::format("period = {} m is not allowed: it must be at least {} m, twice the largest distance "
                      "of two spheres that touch",
                      period[a], 2 * reach));
    }
    length[a] = period[a] > 0 ? period[a] : box.high[a] - box.low[a];
    volume *= length[a];
  }
  // no more cells than a few a sphere, however empty the box
  const double most = 64 + 8.0 * static_cast<double>(expected);
  const double edge = std::max(reach, std::cbrt(volume / most));
  std::size_t total = 1;
  for (int a = 0; a < 3; ++a) {
    cells_[a] = static_cast<int>(std::clamp(std::floor(length[a] / edge), 1.0, most));
    inverse_edge_[a] = cells_[a] / length[a];
    total *= static_cast<std::size_t>(cells_[a]);
  }
  head_.assign(total, -1);
}

int SphereGrid::cell(double x, int axis) const {
  const double at = (x - low_[axis]) * inverse_edge_[axis];
  if (period_[axis] > 0) {
    const double turns = std::floor(at / cells_[axis]);
    return std::clamp(static_cast<int>(at - turns * cells_[axis]), 0, cells_[axis] - 1);
  }
  // what stands outside counts for the cells at the border
  return static_cast<int>(std::clamp(std::floor(at), 0.0, cells_[axis] - 1.0));
}

std::size_t SphereGrid::index(const std::array<int, 3>& c) const {
  return (static_cast<std::size_t>(c[2]) * cells_[1] + c[1]) * cells_[0] + c[0];
}

void SphereGrid::add(const Vec<double, 3>& center, double radius) {
  std::int64_t& head = head_[index({cell(center[0], 0), cell(center[1], 1), cell(center[2], 2)})];
  next_.push_back(head);
  head = static_cast<std::int64_t>(spheres_.radius.size());
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
  std::array<int, 3> at, from, to;
  for (int a = 0; a < 3; ++a) {
    at[a] = cell(center[a], a);
    const bool wraps = period_[a] > 0;
    // every cell once, when there are fewer than three around
    from[a] = wraps ? (cells_[a] > 2 ? -1 : 0) : std::max(-1, -at[a]);
    to[a] = wraps ? std::min(1, cells_[a] - 1) : std::min(1, cells_[a] - 1 - at[a]);
  }
  for (int z = from[2]; z <= to[2]; ++z) {
    for (int y = from[1]; y <= to[1]; ++y) {
      for (int x = from[0]; x <= to[0]; ++x) {
        const std::array<int, 3> c{(at[0] + x + cells_[0]) % cells_[0], (at[1] + y + cells_[1]) % cells_[1],
                                   (at[2] + z + cells_[2]) % cells_[2]};
        for (std::int64_t i = head_[index(c)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
          const auto n = static_cast<std::size_t>(i);
          const Vec<double, 3> r = nearest(center, spheres_.position[n]);
          const double reach = radius + spheres_.radius[n] + gap_;
          if (dot(r, r) < reach * reach) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace fiberchain::dem
