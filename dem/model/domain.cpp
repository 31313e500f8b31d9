#include "dem/model/domain.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::dem {

bool is_active(const Wall& wall, double time) { return time >= wall.active_from && time < wall.active_until; }

bool is_invariant_along(const Wall& wall, int axis) { return wall.shape.is_invariant_along(axis); }

double gap_to(const Wall& wall, const Vec<double, 3>& place, double time) {
  return wall.shape.nearest(place, time * wall.velocity).distance;
}

Vec<double, 3> direction_to(const Wall& wall, const Vec<double, 3>& place, double time) {
  return wall.shape.nearest(place, time * wall.velocity).direction;
}

bool are_same(const Wall& one, const Wall& other) {
  if (one.shape.type().name != other.shape.type().name) return false;
  if (!(std::max(one.active_from, other.active_from) < std::min(one.active_until, other.active_until)))
    return false;
  // no two shapes of a kind have the same gaps from seven places that lie in no plane and on no circle
  constexpr double spread = 0.37;  // [m]
  for (int n = 0; n < 7; ++n) {
    const Vec<double, 3> place{spread * std::cos(1.3 * n), spread * std::sin(1.9 * n + 0.4),
                               spread * std::cos(2.7 * n + 1.1)};
    for (const double time : {0.0, 1.0}) {
      const double a = gap_to(one, place, time), b = gap_to(other, place, time);
      if (std::abs(a - b) > 1e-9 * (std::abs(a) + std::abs(b))) return false;
    }
  }
  return true;
}

}  // namespace fiberchain::dem
