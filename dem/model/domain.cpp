#include "dem/model/domain.hpp"

namespace fiberchain::dem {

bool is_active(const Wall& wall, double time) { return time >= wall.from && time < wall.until; }

bool is_invariant_along(const Wall& wall, int axis) { return wall.shape.is_invariant_along(axis); }

double gap_to(const Wall& wall, const Vec<double, 3>& place, double time) {
  return wall.shape.nearest(place, time * wall.velocity).distance;
}

Vec<double, 3> direction_to(const Wall& wall, const Vec<double, 3>& place, double time) {
  return wall.shape.nearest(place, time * wall.velocity).direction;
}

}  // namespace fiberchain::dem
