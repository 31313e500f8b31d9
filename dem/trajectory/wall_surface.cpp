#include "dem/trajectory/wall_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "dem/mesh/mesh_shape.hpp"
#include "dem/model/shapes/shapes.hpp"

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;

constexpr int kSides = 48;  ///< of a circle: chords are within 1 - cos(pi / 48) = 0.2 % of the radius

/// A box by its corners.
struct Bounds {
  V low, high;

  V middle() const { return 0.5 * (low + high); }
  double diagonal() const { return norm(high - low); }
  std::array<V, 8> corners() const {
    std::array<V, 8> all;
    for (unsigned i = 0; i < 8; ++i)
      all[i] = {i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]};
    return all;
  }
  /// Least and largest distance of corners from a point along a direction.
  std::pair<double, double> extent(const V& from, const V& direction) const {
    std::pair<double, double> all{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};
    for (const V& corner : corners()) {
      const double along = dot(corner - from, direction);
      all = {std::min(all.first, along), std::max(all.second, along)};
    }
    return all;
  }
};

V unit_vector(const V& v) { return (1 / norm(v)) * v; }

/// Two directions across one, the three right-handed.
std::pair<V, V> across(const V& axis) {
  int least = 0;
  for (int c = 1; c < 3; ++c) {
    if (std::abs(axis[c]) < std::abs(axis[least])) least = c;
  }
  V along{};
  along[least] = 1;
  const V u = unit_vector(cross(axis, along));
  return {u, cross(axis, u)};
}

void add_polygon(WallSurface& surface, const std::vector<V>& corners) {
  const auto first = static_cast<std::int32_t>(surface.points.size());
  surface.points.insert(surface.points.end(), corners.begin(), corners.end());
  for (std::int32_t i = 2; i < static_cast<std::int32_t>(corners.size()); ++i)
    surface.triangles.push_back({first, first + i - 1, first + i});
}

/// What of a polygon lies where dot(direction, x) <= end (Sutherland and Hodgman).
std::vector<V> cut(const std::vector<V>& polygon, const V& direction, double end) {
  std::vector<V> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const V &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = dot(direction, a) - end, to = dot(direction, b) - end;
    if (from <= 0) kept.push_back(a);
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.push_back(a + (from / (from - to)) * (b - a));
  }
  return kept;
}

/// Of an angle around a cylinder.
V radial(const std::pair<V, V>& directions, int k) {
  const double angle = 2 * std::numbers::pi * k / kSides;
  return std::cos(angle) * directions.first + std::sin(angle) * directions.second;
}

/// Cut to a cylinder's inside as that is drawn, where the plane is across it.
std::vector<V> cut(std::vector<V> polygon, const V& normal, const Cylinder& cylinder) {
  constexpr double across_it = 0.5;
  if (cylinder.side < 0 || std::abs(dot(normal, cylinder.axis)) < across_it) return polygon;
  const auto directions = across(cylinder.axis);
  const double inner = cylinder.radius * std::cos(std::numbers::pi / kSides);
  for (int k = 0; k < kSides; ++k) {
    const V middle = unit_vector(radial(directions, k) + radial(directions, k + 1));
    polygon = cut(polygon, middle, dot(middle, cylinder.point) + inner);
  }
  return polygon;
}

void add_plane(WallSurface& surface, const Plane& plane, const Bounds& box, const std::vector<Wall>& walls) {
  const auto [u, v] = across(plane.normal);
  const V middle = box.middle() - dot(box.middle() - plane.point, plane.normal) * plane.normal;
  const double far = box.diagonal(), round_off = 1e-9 * far;
  std::vector<V> polygon = {middle - far * u - far * v, middle + far * u - far * v,
                            middle + far * u + far * v, middle - far * u + far * v};
  for (int c = 0; c < 3; ++c) {
    V side{};
    side[c] = 1;
    polygon = cut(polygon, side, box.high[c] + round_off);
    polygon = cut(polygon, -side, round_off - box.low[c]);
  }
  if (polygon.size() < 3) {
    const auto [u0, u1] = box.extent(middle, u);
    const auto [v0, v1] = box.extent(middle, v);
    polygon = {middle + u0 * u + v0 * v, middle + u1 * u + v0 * v, middle + u1 * u + v1 * v,
               middle + u0 * u + v1 * v};
  }
  for (const Wall& wall : walls) {
    const auto* cylinder = wall.shape.get_if<Cylinder>();
    if (cylinder == nullptr) continue;
    const std::vector<V> within = cut(polygon, plane.normal, *cylinder);
    if (within.size() >= 3) polygon = within;
  }
  add_polygon(surface, polygon);
}

/// Places along an axis and off it.
using Profile = std::vector<std::pair<double, double>>;

/// A profile turned about an axis; rings on the axis are points.
void add_revolved(WallSurface& surface, const V& origin, const V& axis, const Profile& profile) {
  const auto directions = across(axis);
  const auto first = static_cast<std::int32_t>(surface.points.size());
  for (const auto& [along, off] : profile) {
    for (int k = 0; k < kSides; ++k)
      surface.points.push_back(origin + along * axis + off * radial(directions, k));
  }
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
    const std::int32_t from = first + static_cast<std::int32_t>(ring) * kSides;
    for (std::int32_t k = 0; k < kSides; ++k) {
      const std::int32_t a = from + k, b = from + (k + 1) % kSides, c = a + kSides, d = b + kSides;
      if (profile[ring].second > 0) surface.triangles.push_back({a, b, d});
      if (profile[ring + 1].second > 0) surface.triangles.push_back({a, d, c});
    }
  }
}

void add_cylinder(WallSurface& surface, const Cylinder& cylinder, const Bounds& box) {
  const auto [from, to] = box.extent(cylinder.point, cylinder.axis);
  add_revolved(surface, cylinder.point, cylinder.axis, {{from, cylinder.radius}, {to, cylinder.radius}});
}

void add_sphere(WallSurface& surface, const Sphere& sphere) {
  Profile profile;
  for (int n = 0; n <= kSides / 2; ++n) {
    const double angle = std::numbers::pi * n / (kSides / 2);
    const bool pole = n == 0 || n == kSides / 2;
    profile.emplace_back(-sphere.radius * std::cos(angle), pole ? 0 : sphere.radius * std::sin(angle));
  }
  add_revolved(surface, sphere.point, {0, 0, 1}, profile);
}

/// The shell around a straight segment of the half plane, rounded at both rims.
void add_cone(WallSurface& surface, const Cone& cone) {
  const double wider = cone.end_radius - cone.radius, slant = std::hypot(cone.length, wider);
  if (cone.half == 0) {
    add_revolved(surface, cone.point, cone.axis, {{0, cone.radius}, {cone.length, cone.end_radius}});
    return;
  }
  constexpr int arc = 6;  // chords of half a rim
  const double tilt =
      std::atan2(cone.length / slant, -wider / slant);  // of the shell's normal, from the axis
  Profile profile;
  const auto add = [&](double along, double off, double angle) {
    profile.emplace_back(along + cone.half * std::cos(angle),
                         std::max(off + cone.half * std::sin(angle), 0.0));
  };
  for (int n = 0; n <= arc; ++n) add(cone.length, cone.end_radius, tilt - std::numbers::pi * n / arc);
  for (int n = 0; n <= arc; ++n) add(0, cone.radius, tilt - std::numbers::pi - std::numbers::pi * n / arc);
  profile.push_back(profile.front());
  add_revolved(surface, cone.point, cone.axis, profile);
}

void add_box(WallSurface& surface, const BoxObstacle& box) {
  const V third = cross(box.along, box.across);
  const V sides[] = {box.half[0] * box.along, box.half[1] * box.across, box.half[2] * third};
  for (int c = 0; c < 3; ++c) {
    const V &out = sides[c], &u = sides[(c + 1) % 3], &v = sides[(c + 2) % 3];
    const V high = box.point + out, low = box.point - out;
    add_polygon(surface, {high - u - v, high + u - v, high + u + v, high - u + v});
    add_polygon(surface, {low - u - v, low - u + v, low + u + v, low + u - v});
  }
}

void add_mesh(WallSurface& surface, const MeshShape& shape) {
  for (const V& vertex : shape.mesh->vertices) surface.points.push_back(shape.point + shape.to_space(vertex));
  surface.triangles = shape.mesh->triangles;
}

/// A further kind is a line here.
WallSurface surface_of(const WallShape& shape, const Bounds& box, const std::vector<Wall>& walls) {
  WallSurface surface{.shape = std::string(shape.type().name), .points = {}, .triangles = {}};
  if (const auto* plane = shape.get_if<Plane>()) add_plane(surface, *plane, box, walls);
  if (const auto* cylinder = shape.get_if<Cylinder>()) add_cylinder(surface, *cylinder, box);
  if (const auto* sphere = shape.get_if<Sphere>()) add_sphere(surface, *sphere);
  if (const auto* obstacle = shape.get_if<BoxObstacle>()) add_box(surface, *obstacle);
  if (const auto* cone = shape.get_if<Cone>()) add_cone(surface, *cone);
  if (const auto* mesh = shape.get_if<MeshShape>()) add_mesh(surface, *mesh);
  return surface;
}

/// The box and all walls that have an extent; cylinders have one across their axes.
Bounds bounds_with(const std::vector<Wall>& walls, Bounds box) {
  const Bounds given = box;
  for (const Wall& wall : walls) {
    if (wall.shape.get_if<Plane>() != nullptr) continue;
    for (const V& point : surface_of(wall.shape, given, walls).points) {
      for (int c = 0; c < 3; ++c)
        box.low[c] = std::min(box.low[c], point[c]), box.high[c] = std::max(box.high[c], point[c]);
    }
  }
  return box;
}

}  // namespace

std::vector<WallSurface> wall_surfaces(const std::vector<Wall>& walls, const V& low, const V& high) {
  const Bounds box = bounds_with(walls, {low, high});
  std::vector<WallSurface> all;
  for (const Wall& wall : walls) all.push_back(surface_of(wall.shape, box, walls));
  return all;
}

FrameWall frame_wall(const Wall& wall, double time) {
  const WallPose pose = pose_at(wall, time);
  const V about = pose.turned ? rotate(pose.turn, pose.center) : pose.center;
  return {.offset = pose.center_now() - about, .turn = pose.turn, .is_there = is_active(wall, time)};
}

}  // namespace fiberchain::dem
