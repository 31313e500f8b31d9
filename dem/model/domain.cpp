#include "dem/model/domain.hpp"

#include <cmath>

namespace fiberchain::dem {
namespace {

/// From the cylinder's axis to a place.
Vec<double, 3> out_from_axis(const Wall& wall, const Cylinder& cylinder, const Vec<double, 3>& place, double time) {
  const Vec<double, 3> from = place - cylinder.point - time * wall.velocity;
  return from - dot(from, cylinder.axis) * cylinder.axis;
}

}  // namespace

bool is_active(const Wall& wall, double time) { return time >= wall.from && time < wall.until; }

bool is_invariant_along(const Wall& wall, int axis) {
  constexpr double straight = 1e-12;
  if (const auto* plane = std::get_if<Plane>(&wall.shape)) return std::abs(plane->normal[axis]) < straight;
  return std::abs(std::get<Cylinder>(wall.shape).axis[axis]) > 1 - straight;
}

double gap_to(const Wall& wall, const Vec<double, 3>& place, double time) {
  if (const auto* plane = std::get_if<Plane>(&wall.shape)) {
    return dot(place - plane->point - time * wall.velocity, plane->normal);
  }
  const auto& cylinder = std::get<Cylinder>(wall.shape);
  return cylinder.radius - norm(out_from_axis(wall, cylinder, place, time));
}

Vec<double, 3> direction_to(const Wall& wall, const Vec<double, 3>& place, double time) {
  if (const auto* plane = std::get_if<Plane>(&wall.shape)) return -plane->normal;
  const Vec<double, 3> out = out_from_axis(wall, std::get<Cylinder>(wall.shape), place, time);
  return (1 / norm(out)) * out;
}

}  // namespace fiberchain::dem
