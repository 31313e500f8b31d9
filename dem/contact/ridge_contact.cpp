#include "dem/contact/ridge_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fiberchain::dem {
namespace {

using V = Vec<double, 3>;

/// Sines of the angle from the plane across an edge into a face: there points count, and from there on they
/// fade as the face is nearer.
constexpr double leaning = 0.2, averted = 0.3;

/// Beyond the end of an edge, over the distance: round-off.
constexpr double beyond_end = 1e-9;

double seen_at(double sine) { return within_one((averted - sine) / (averted - leaning)); }

SegmentNodes<double> edge_nodes(const TriangleMesh& mesh, std::int32_t number) {
  const MeshEdge& edge = mesh.edges[number];
  const V &low = mesh.vertices[edge.low], &high = mesh.vertices[edge.high];
  return {low, low, high, high, 0};
}

/// How much of a contact an edge is in a direction: none where it falls in.
double seen_at_edge(const MeshRidges& ridges, std::int32_t edge, const V& direction) {
  const auto faces = ridges.into_faces_at(edge);
  double least = 1;
  for (const V& into : faces) least = std::min(least, seen_at(-dot(direction, into)));
  // from the side on which it stands out the segment is behind both faces
  if (faces.size() == 2 && dot(direction, faces[0] + faces[1]) <= 0) return 0;
  return least;
}

/// The same of a corner: none where one of its ridges comes nearer.
double seen_at_corner(const MeshRidges& ridges, std::int32_t corner, const V& direction) {
  double least = 1;
  for (const MeshRidges::Way& way : ridges.ways_from(corner)) {
    const double sine = -dot(direction, way.along);
    least = std::min(least, way.is_ridge ? (sine > beyond_end ? 0.0 : 1.0) : seen_at(sine));
  }
  return least;
}

double seen_at_feature(const TriangleMesh& mesh, const MeshRidges& ridges, std::int32_t feature,
                       const V& direction) {
  return mesh.kind_of(feature) == FeatureKind::corner
             ? seen_at_corner(ridges, feature - mesh.corner_feature(0), direction)
             : seen_at_edge(ridges, feature - mesh.faces(), direction);
}

/// From a place to the closest point of an edge, or to a corner.
V to_feature(const TriangleMesh& mesh, std::int32_t feature, const V& from) {
  return closest_on_feature(mesh, feature, from).to;
}

/// Of a joint, as share_at_joint() of two fibers.
double share_at(const TriangleMesh& mesh, const RidgePoint& point, const V& joint, const V& inside,
                const V& outside, double even) {
  V to = to_feature(mesh, point.feature, joint);
  return share_at_joint(to, joint, inside, outside, even);
}

double hertz(double overlap) { return overlap > 0 ? overlap * std::sqrt(overlap) : 0; }

/// What a contact in a direction counts for one in another: all within 20 degrees, none beyond 60.
double likeness(const V& a, const V& b) { return within_one((dot(a, b) - 0.5) / (smooth_cosine - 0.5)); }

/// Of two places along a segment: 1 within a radius, 0 beyond a diameter.
double near(double apart, double radius) { return within_one(2 - apart / radius); }

/// What a point has of the force of those near to it.
double part_of_group(const RidgePoint& own, std::span<const RidgePoint> points, double length, double R) {
  double largest = 0, sum = 0;
  for (const RidgePoint& other : points) {
    const double counts = other.seen * hertz(R - other.distance) *
                          near(std::abs(other.place - own.place) * length, R) *
                          likeness(own.direction, other.direction);
    largest = std::max(largest, counts), sum += counts;
  }
  return sum > 0 ? largest / sum : 0;
}

/// Whether two features are one, or join at a corner along one line.
bool go_on(const TriangleMesh& mesh, std::int32_t a, std::int32_t b) {
  if (a == b) return true;
  const bool corner_a = mesh.kind_of(a) == FeatureKind::corner,
             corner_b = mesh.kind_of(b) == FeatureKind::corner;
  if (mesh.kind_of(a) == FeatureKind::face || mesh.kind_of(b) == FeatureKind::face || (corner_a && corner_b))
    return false;
  if (corner_a) std::swap(a, b);
  const MeshEdge& edge = mesh.edge_at(a);
  if (corner_a || corner_b) {
    const std::int32_t corner = b - mesh.corner_feature(0);
    return corner == edge.low || corner == edge.high;
  }
  const MeshEdge& other = mesh.edge_at(b);
  if (edge.low != other.low && edge.low != other.high && edge.high != other.low && edge.high != other.high)
    return false;
  const V u = mesh.vertices[edge.high] - mesh.vertices[edge.low],
          v = mesh.vertices[other.high] - mesh.vertices[other.low];
  return std::abs(dot(u, v)) > smooth_cosine * norm(u) * norm(v);
}

/// Whether a node touches what a point of its segment does, or close to it.
bool is_same(const TriangleMesh& mesh, const NodeContact& node, const RidgePoint& point, const V& touched,
             double R) {
  constexpr double close = 0.1;  // of the radius
  const V apart = node.point - touched;
  return go_on(mesh, node.feature, point.feature) || dot(apart, apart) < close * close * R * R;
}

/// 1 where a body lies flat, 0 from ridge_tilt on; `rise` over `apart`.
double flatness(double rise, double apart, double radius) {
  return within_one(1 - rise / (ridge_tilt * std::max(apart, 1e-9 * radius)));
}

/// What is known of a point of a segment.
struct PointBeside {
  const TriangleMesh& mesh;
  const RidgePoint& point;
  V touched;      ///< of the mesh
  double sine;    ///< of the angle between segment and ridge
  double length;  ///< of the segment [m]
  double R;
};

/// Of a node beside a point of its segment, in about its direction.
struct NodeBeside {
  double apart;                                          ///< [m]
  double flat = 0;                                       ///< flatness, with anything
  double other = 0;                                      ///< with other things
  double distance = std::numeric_limits<double>::max();  ///< from those [m]
  double like = 0;                                       ///< how much these count
  double along = 0;                                      ///< flat, and the segment lies along the ridge
};

/// `apart` goes from the node to the point, along the segment's unit vector or against it.
NodeBeside node_beside(std::span<const NodeContact> node, const PointBeside& at, double apart,
                       const V& onward) {
  NodeBeside beside{apart};
  const double d = at.point.distance;
  for (const NodeContact& c : node) {
    const bool same = is_same(at.mesh, c, at.point, at.touched, at.R);
    // against what else lies under the node it may be tilted more than the mean on the way
    const double like = likeness(c.direction, at.point.direction), rise = c.distance - d,
                 tilted = same ? rise : std::max(rise, apart * dot(onward, c.direction)),
                 flat = like * flatness(tilted, apart, at.R);
    beside.flat = std::max(beside.flat, flat);
    if (same) continue;
    if (like > 0 && c.distance < beside.distance)
      beside.other = flat, beside.distance = c.distance, beside.like = like;
  }
  beside.along = beside.flat * flatness(std::hypot(d, apart * at.sine) - d, apart, at.R);
  return beside;
}

/// A node leaves a contact with the same thing to a point of its segment, but for what the other node has.
void leave_to(const PointBeside& at, std::span<NodeContact> node, double other_has) {
  for (NodeContact& c : node) {
    if (!is_same(at.mesh, c, at.point, at.touched, at.R)) continue;
    const double left = at.point.seen * likeness(c.direction, at.point.direction) * (1 - other_has);
    c.share = std::min(c.share, 1 - left);
  }
}

/// What of a point its nodes bear.
double shadow(const PointBeside& at, const NodeBeside& begin, const NodeBeside& end) {
  const double s = at.point.place, half = std::min(at.R, 0.5 * at.length);
  double between = 0;
  if (begin.like > 0 && end.like > 0) {
    const double rise = (1 - s) * begin.distance + s * end.distance - at.point.distance;
    between = std::min(begin.like, end.like) * flatness(rise, std::min(begin.apart, end.apart), at.R);
  }
  return std::max({between, near(begin.apart, half) * begin.other, near(end.apart, half) * end.other,
                   std::min(begin.along, end.along)});
}

/// Sine of the angle between a segment and an edge; 1 at a corner.
double sine_at(const TriangleMesh& mesh, std::int32_t feature, const V& along) {
  if (mesh.kind_of(feature) == FeatureKind::corner) return 1;
  const MeshEdge& edge = mesh.edge_at(feature);
  const V u = mesh.vertices[edge.high] - mesh.vertices[edge.low];
  return norm(cross(u, along)) / std::max(norm(u) * norm(along), 1e-290);
}

}  // namespace

RidgePoint ridge_point(const TriangleMesh& mesh, std::int32_t feature, const SegmentNodes<double>& segment) {
  V to;
  double place;
  if (mesh.kind_of(feature) == FeatureKind::corner) {
    const V& corner = mesh.vertex_at(feature);
    double foot;
    to = -to_segment(corner, segment.begin, segment.end, foot);
    place = within_one(foot);
  } else {
    const SegmentNodes<double> edge = edge_nodes(mesh, feature - mesh.faces());
    const ClosestPlaces<double> at = closest_places(segment, edge);
    to = separation(segment, edge, at.first, at.second);
    place = at.first;
  }
  const double distance = norm(to);
  return {feature, place, (1 / std::max(distance, 1e-290)) * to, distance, 1};
}

double find_ridge_points(const TriangleMesh& mesh, const MeshRidges& ridges, MeshSides sides,
                         std::span<const std::int32_t> edges, const SegmentNodes<double>& segment,
                         double reach, std::vector<RidgePoint>& found) {
  found.clear();
  double least = std::numeric_limits<double>::infinity();
  for (const std::int32_t e : edges) {
    const SegmentNodes<double> edge = edge_nodes(mesh, e);
    const ClosestPlaces<double> at = closest_places(segment, edge);
    const V to = separation(segment, edge, at.first, at.second);
    const double squared = dot(to, to);
    least = std::min(least, squared);
    if (!(squared < reach * reach) || !(at.first > 0 && at.first < 1)) continue;
    const std::int32_t feature = at.second <= 0   ? mesh.corner_feature(mesh.edges[e].low)
                                 : at.second >= 1 ? mesh.corner_feature(mesh.edges[e].high)
                                                  : mesh.edge_feature(e);
    if (std::ranges::find(found, feature, &RidgePoint::feature) != found.end()) continue;
    // corners from their own numbers, whichever edge asks: all get the same bits
    RidgePoint point = ridge_point(mesh, feature, segment);
    const ClosestPoint closest{feature, point.direction, 1};
    if (sides == MeshSides::one && !mesh.is_rim(feature) && !is_outside(mesh, closest)) continue;
    point.seen = seen_at_feature(mesh, ridges, feature, point.direction);
    if (point.seen > 0 && point.distance < reach) found.push_back(point);
  }
  std::ranges::sort(found, {}, &RidgePoint::feature);
  return std::sqrt(least);
}

void share_out(const TriangleMesh& mesh, const SegmentNodes<double>& segment, const EndContacts& ends,
               std::span<RidgePoint> points) {
  const double R = segment.radius, length = norm(segment.end - segment.begin), even = 1e-9 * R * R;
  for (RidgePoint& own : points) {
    const PointBeside at{mesh,
                         own,
                         along(segment, own.place) + own.distance * own.direction,
                         sine_at(mesh, own.feature, segment.end - segment.begin),
                         length,
                         R};
    const V onward = (1 / length) * (segment.end - segment.begin);
    const NodeBeside begin = node_beside(ends.begin, at, own.place * length, onward),
                     end = node_beside(ends.end, at, (1 - own.place) * length, -onward);
    leave_to(at, ends.begin, end.along);
    leave_to(at, ends.end, begin.along);
    own.share = own.seen * part_of_group(own, points, length, R) * (1 - shadow(at, begin, end)) *
                share_at(mesh, own, segment.begin, segment.end, segment.before, even) *
                share_at(mesh, own, segment.end, segment.begin, segment.behind, even);
  }
}

}  // namespace fiberchain::dem
