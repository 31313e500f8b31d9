#include "dem/mesh/mesh_shape.hpp"

#include <cmath>

namespace fiberchain::dem {
namespace {

/// Seen from outside, from either side; from behind where a mesh is of one side.
NearestPoint<double> seen(const MeshShape& shape, const ClosestPoint& closest, bool from_behind) {
  const Vec<double, 3> direction = shape.to_space(direction_of(*shape.mesh, closest));
  const double distance = std::sqrt(closest.squared);
  if (from_behind) return {-direction, -distance};
  return {direction, distance};
}

}  // namespace

NearestPoint<double> MeshShape::nearest(const Vec<double, 3>& from) const {
  const ClosestPoint closest = nearest_point(*mesh, turned ? rotate(conjugate(turned_by), from) : from);
  return seen(*this, closest, sides == MeshSides::one && mesh->is_closed && !is_outside(*mesh, closest));
}

NearestPoint<double> MeshShape::nearest_of_feature(std::int32_t feature, const Vec<double, 3>& place) const {
  const ClosestPoint closest = closest_on_feature(*mesh, feature, to_mesh(place));
  const bool behind =
      sides == MeshSides::one && !mesh->is_rim(closest.feature) && !is_outside(*mesh, closest);
  return seen(*this, closest, behind);
}

const MeshShape* mesh_in(const Wall& wall) { return wall.shape.get_if<MeshShape>(); }

bool passes_through(const Wall& wall, const Vec<double, 3>& from, const Vec<double, 3>& to, double time) {
  const MeshShape* shape = mesh_in(wall);
  if (shape == nullptr) return false;
  const MeshShape at = moved(*shape, pose_at(wall, time));
  const Vec<double, 3> a = at.to_mesh(from), b = at.to_mesh(to);
  MeshBox box{a, a};
  box.add(b);
  bool found = false;
  at.mesh->search.overlapping(box,
                              [&](std::int32_t t) { found = found || pierces(at.mesh->planes[t], a, b); });
  return found;
}

}  // namespace fiberchain::dem
