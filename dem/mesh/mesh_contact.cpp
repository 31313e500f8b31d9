#include "dem/mesh/mesh_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fiberchain::dem {
namespace {

/// On the edge from its low to its high corner, whichever triangle asks: all get the same bits.
ClosestPoint closest_on_edge(const TriangleMesh& mesh, std::int32_t number, const Vec<double, 3>& center) {
  const MeshEdge& edge = mesh.edges[number];
  const Vec<double, 3>& low = mesh.vertices[edge.low];
  const Vec<double, 3> along = mesh.vertices[edge.high] - low, from = center - low;
  const double share = dot(from, along), whole = dot(along, along);
  if (share <= 0) return {mesh.corner_feature(edge.low), -from, dot(from, from)};
  if (share >= whole) {
    const Vec<double, 3> to = mesh.vertices[edge.high] - center;
    return {mesh.corner_feature(edge.high), to, dot(to, to)};
  }
  const Vec<double, 3> to = (share / whole) * along - from;
  return {mesh.edge_feature(number), to, dot(to, to)};
}

/// Where a place is over a triangle; reads nothing but its plane.
struct PlaceOver {
  double height;  ///< over the plane [m]
  std::array<double, 3>
      side;              ///< inside of each side, from its corner to the next: share of the third corner
  double squared_bound;  ///< of the distance, from below: of the plane, and of the side's line beyond one

  bool is_inside() const { return side[0] > 0 && side[1] > 0 && side[2] > 0; }
};

PlaceOver place_over(const TrianglePlane& plane, const Vec<double, 3>& center) {
  const Vec<double, 3> from = center - plane.corner;
  const double second = dot(from, plane.to_second), third = dot(from, plane.to_third);
  PlaceOver place{dot(from, plane.normal), {third, 1 - second - third, second}, 0};
  // shares of corners rise by their gradients' sizes per length
  const auto beyond = [](double share, const Vec<double, 3>& gradient) {
    return share < 0 ? share * share / dot(gradient, gradient) : 0.0;
  };
  place.squared_bound =
      place.height * place.height + std::max({beyond(place.side[0], plane.to_third),
                                              beyond(place.side[1], plane.to_second + plane.to_third),
                                              beyond(place.side[2], plane.to_second)});
  return place;
}

/// Whether a center that is over the inside of one face is nearest to another face on a side that both share,
/// and so not at a least distance of its own.
bool is_nearest_at_shared_side(const TriangleMesh& mesh, const BesideTriangle& beside, std::int32_t over) {
  if (over < 0 || beside.only_side < 0) return false;
  const std::int32_t edge = mesh.edges_of[beside.triangle][beside.only_side];
  const auto& sides = mesh.edges_of[over];
  return edge == sides[0] || edge == sides[1] || edge == sides[2];
}

/// The number of the only side that a place is beyond; -1 if there are two.
int only_side(const PlaceOver& place) {
  int side = -1, count = 0;
  for (int k = 0; k < 3; ++k) {
    if (!(place.side[k] > 0)) side = k, ++count;
  }
  return count == 1 ? side : -1;
}

/// Of a bound.
constexpr double round_off = 1 + 1e-9;

/// The closest points of triangles that are nearer than `reach`, but for some that are at no least distance;
/// the least distance of all, or what is less [m^2].
double collect_points(const TriangleMesh& mesh, std::span<const std::int32_t> triangles,
                      const Vec<double, 3>& center, double reach, MeshContactScratch& scratch) {
  const double reached = reach * reach * round_off;
  scratch.points.clear(), scratch.beside.clear();
  double least = std::numeric_limits<double>::infinity();
  std::int32_t over = -1;
  for (const std::int32_t t : triangles) {
    const PlaceOver place = place_over(mesh.planes[t], center);
    least = std::min(least, place.squared_bound);
    if (place.squared_bound > reached) continue;
    if (!place.is_inside()) {
      scratch.beside.push_back({t, only_side(place)});
    } else if (std::abs(place.height) < reach) {
      scratch.points.push_back({t, -place.height * mesh.planes[t].normal, place.height * place.height});
      over = t;
    }
  }
  for (const BesideTriangle& beside : scratch.beside) {
    if (is_nearest_at_shared_side(mesh, beside, over)) continue;
    const ClosestPoint point = closest_point(mesh, beside.triangle, center);
    if (std::sqrt(point.squared) < reach) scratch.points.push_back(point);
  }
  return least / round_off;
}

/// Normal of the surface at a feature, of any length.
const Vec<double, 3>& outward_at(const TriangleMesh& mesh, std::int32_t feature) {
  switch (mesh.kind_of(feature)) {
    case FeatureKind::face:
      return mesh.planes[feature].normal;
    case FeatureKind::edge:
      return mesh.edge_at(feature).outward;
    default:
      return mesh.corner_at(feature).outward;
  }
}

bool is_nearer(const ClosestPoint& a, const ClosestPoint& b) {
  return a.squared < b.squared || (a.squared == b.squared && a.feature < b.feature);
}

/// Of points sorted by feature, one a feature that all triangles at it have; the nearest in any case: where
/// round-off has triangles disagree.
void keep_least_distances(const TriangleMesh& mesh, std::vector<ClosestPoint>& points) {
  const ClosestPoint nearest = *std::ranges::min_element(points, is_nearer);
  std::ranges::sort(points, {}, &ClosestPoint::feature);
  std::size_t kept = 0;
  for (std::size_t n = 0; n < points.size();) {
    const ClosestPoint point = points[n];
    std::int32_t count = 0;
    for (; n < points.size() && points[n].feature == point.feature; ++n) ++count;
    if (count == mesh.valence(point.feature) || point.feature == nearest.feature) points[kept++] = point;
  }
  points.resize(kept);
}

/// Adds a contact unless a nearer one has about its direction.
void add_contact(const TriangleMesh& mesh, const ClosestPoint& point, std::vector<MeshContact>& contacts) {
  const MeshContact own{point.feature, direction_of(mesh, point), std::sqrt(point.squared)};
  const auto is_near = [&](const MeshContact& other) {
    return dot(other.direction, own.direction) > smooth_cosine;
  };
  if (std::ranges::none_of(contacts, is_near)) contacts.push_back(own);
}

/// As far as a center that is over the inside of a face, whose plane it is `height` above, may go until
/// another triangle could make a contact of its own or the nearer one [m].
double stays_behind(const TriangleMesh& mesh, std::int32_t triangle, const FlatPlace& face, double height,
                    const Vec<double, 3>& center, double reach) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double out_of_sight = reach + face.margin;
  if (squared_distance_bound(mesh, triangle, center) > out_of_sight * out_of_sight) return never;
  double highest = -never;
  for (const std::int32_t v : mesh.triangles[triangle])
    highest = std::max(highest, dot(mesh.vertices[v] - face.corner, face.normal));
  // with a point nearly in the plane, no nearer than the foot on the face unless the foot has all but left it
  constexpr double level = 1e-9;
  if (height > 0 && highest <= level * reach) return never;
  const ClosestPoint other = closest_point(mesh, triangle, center);
  const double distance = std::sqrt(other.squared), out_of_reach = distance - reach;
  if (height <= 0) return out_of_reach;
  // no nearer than its plane, whose distance less the face's changes with the difference of normals; and the
  // closest point goes no farther than the center
  const TrianglePlane& plane = mesh.planes[triangle];
  const double farther = dot(center - plane.corner, plane.normal) - height;
  double behind = std::max(0.5 * (distance - height), farther / norm(plane.normal - face.normal));
  if (highest > low_triangle * reach) {  // in about the face's direction?
    constexpr double turned = 0.05;      // rad, of the direction; its cosine is off by less
    const bool is_merged = -dot(other.to, face.normal) > (smooth_cosine + turned) * distance;
    behind = is_merged ? std::min(behind, 0.4 * turned * distance) : 0;
  }
  return std::max(out_of_reach, behind);
}

/// Of the reach: flat places that reach less far are none; the way to a triangle in one plane, squared, is
/// above what round-off and stays_behind() leave open.
constexpr double least_flat_margin = 3e-4;

}  // namespace

ClosestPoint closest_point(const TriangleMesh& mesh, std::int32_t t, const Vec<double, 3>& center) {
  const PlaceOver place = place_over(mesh.planes[t], center);
  if (place.is_inside()) return {t, -place.height * mesh.planes[t].normal, place.height * place.height};
  // it is on a side that the center is beyond
  ClosestPoint best{0, {}, std::numeric_limits<double>::infinity()};
  for (int k = 0; k < 3; ++k) {
    if (place.side[k] > 0) continue;
    const ClosestPoint own = closest_on_edge(mesh, mesh.edges_of[t][k], center);
    if (is_nearer(own, best)) best = own;
  }
  return best;
}

double squared_distance_bound(const TriangleMesh& mesh, std::int32_t triangle, const Vec<double, 3>& center) {
  return place_over(mesh.planes[triangle], center).squared_bound / round_off;
}

ClosestPoint closest_on_feature(const TriangleMesh& mesh, std::int32_t feature,
                                const Vec<double, 3>& center) {
  switch (mesh.kind_of(feature)) {
    case FeatureKind::face:
      return closest_point(mesh, feature, center);
    case FeatureKind::edge:
      return closest_on_edge(mesh, feature - mesh.faces(), center);
    default:
      const Vec<double, 3> to = mesh.vertex_at(feature) - center;
      return {feature, to, dot(to, to)};
  }
}

ClosestPoint nearest_point(const TriangleMesh& mesh, const Vec<double, 3>& center) {
  const std::int32_t t =
      mesh.search.nearest(center, [&](std::int32_t n) { return closest_point(mesh, n, center).squared; });
  return closest_point(mesh, t, center);
}

bool is_outside(const TriangleMesh& mesh, const ClosestPoint& closest) {
  return dot(closest.to, outward_at(mesh, closest.feature)) <= 0;
}

Vec<double, 3> direction_of(const TriangleMesh& mesh, const ClosestPoint& closest) {
  const Vec<double, 3>& outward = outward_at(mesh, closest.feature);
  if (mesh.kind_of(closest.feature) == FeatureKind::face)
    return dot(closest.to, outward) > 0 ? outward : -outward;
  if (closest.squared > 1e-290) return (1 / std::sqrt(closest.squared)) * closest.to;
  const double length = norm(outward);
  return length > 0 ? (-1 / length) * outward : Vec<double, 3>{0, 0, -1};
}

FlatPlace flat_place(const TriangleMesh& mesh, std::span<const std::int32_t> triangles,
                     const Vec<double, 3>& center, double reach, double most) {
  FlatPlace flat;
  flat.center = center;
  double height = std::numeric_limits<double>::infinity();
  for (const std::int32_t t : triangles) {
    const TrianglePlane& plane = mesh.planes[t];
    const PlaceOver place = place_over(plane, center);
    if (!place.is_inside() || std::abs(place.height) >= std::abs(height)) continue;
    height = place.height;
    const double inside = std::min({place.side[0] / norm(plane.to_third),
                                    place.side[1] / norm(plane.to_second + plane.to_third),
                                    place.side[2] / norm(plane.to_second)});
    flat.face = t, flat.corner = plane.corner, flat.normal = plane.normal;
    flat.margin = std::min(most, 0.999 * inside);
  }
  flat.alone = triangles.size() == 1;
  for (const std::int32_t t : triangles) {
    if (!(flat.margin > least_flat_margin * reach)) break;
    if (t != flat.face)
      flat.margin = std::min(flat.margin, stays_behind(mesh, t, flat, height, center, reach));
  }
  if (!(flat.margin > least_flat_margin * reach)) flat.margin = 0;
  return flat;
}

double find_mesh_contacts(const TriangleMesh& mesh, MeshSides sides, std::span<const std::int32_t> triangles,
                          const Vec<double, 3>& center, double reach, bool held,
                          MeshContactScratch& scratch) {
  std::vector<ClosestPoint>& points = scratch.points;
  scratch.contacts.clear();
  const double least = collect_points(mesh, triangles, center, reach, scratch);
  if (points.empty()) return std::sqrt(least);
  if (points.size() > 1) {
    keep_least_distances(mesh, points);
    std::ranges::sort(points, is_nearer);
  }
  const ClosestPoint nearest = points.front();
  const bool one_sided = sides == MeshSides::one && !mesh.is_rim(nearest.feature);
  if (one_sided && !is_outside(mesh, nearest)) {
    if (mesh.is_closed || held)
      scratch.contacts.push_back(
          {nearest.feature, -direction_of(mesh, nearest), -std::sqrt(nearest.squared)});
    return std::sqrt(least);
  }
  for (const ClosestPoint& point : points) {
    if (sides == MeshSides::one && !mesh.is_rim(point.feature) && !is_outside(mesh, point)) continue;
    add_contact(mesh, point, scratch.contacts);
  }
  std::ranges::sort(scratch.contacts, {}, &MeshContact::feature);
  return std::sqrt(least);
}

}  // namespace fiberchain::dem
