#include "dem/contact/fiber_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fiberchain::dem {
namespace {

/// Length of a segment over that at rest, at most; the neighbor list refuses longer ones.
constexpr double kLongest = 1.3;

}  // namespace

int bodies_apart(const Chain<3>& chain) {
  if (!chain.smooth) return 1;
  const double along = std::numbers::pi * sphere_radius(chain.fiber) / bond_length(chain.fiber);
  return std::max(1, static_cast<int>(std::ceil(along)));
}

void FiberBodies::add(const Chain<3>& chain, int count) {
  const double R = sphere_radius(chain.fiber), half = 0.5 * kLongest * bond_length(chain.fiber);
  groups.push_back({chain.fiber.aspect_ratio + 1, count, R, chain.smooth ? R + half : R, bodies_apart(chain),
                    chain.smooth});
  smooth = smooth || chain.smooth;
}

void FiberBodies::build(int pads) {
  before.clear(), end.clear(), behind.clear();
  apart.clear(), radius.clear(), bound.clear();
  if (!smooth) return;
  std::int32_t first = 0;
  for (const BodyGroup& group : groups) {
    for (int f = 0; f < group.fibers; ++f, first += group.spheres) {
      const std::int32_t last = first + group.spheres - 1;
      for (std::int32_t i = first; i <= last; ++i) {
        before.push_back(group.smooth ? std::max(first, i - 1) : i);
        end.push_back(!group.smooth ? i : i < last ? i + 1 : -1);
        behind.push_back(group.smooth ? std::min(last, i + 2) : i);
      }
    }
    apart.resize(end.size(), group.apart);
    radius.resize(end.size(), group.radius);
    bound.resize(end.size(), group.bound);
  }
  part();
  for (int k = 0; k < pads; ++k, ++first) {
    for (std::vector<std::int32_t>* numbers : {&before, &end, &behind}) numbers->push_back(first);
  }
}

void FiberBodies::part() {
  const auto joined = [&](std::int64_t node) { return node > 0 && end[node - 1] == node; };
  for (const std::int64_t row : parted) {
    if (end[row] != row + 1) continue;  // spheres
    end[row] = -1;
    before[row + 1] = static_cast<std::int32_t>(row + 1);
    if (joined(row)) behind[row - 1] = static_cast<std::int32_t>(row);
  }
  for (const std::int64_t row : parted) {
    for (const std::int64_t node : {row, row + 1}) {
      if (is_none(node) && !joined(node))
        before[node] = end[node] = behind[node] = static_cast<std::int32_t>(node);
    }
  }
}

double FiberBodies::largest_bound() const {
  double largest = 0;
  for (const BodyGroup& group : groups) largest = std::max(largest, group.bound);
  return largest;
}

}  // namespace fiberchain::dem
