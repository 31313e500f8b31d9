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

/// Whether a node touches what a point of its segment does: the same feature, or close to it.
bool is_same(const NodeContact& node, const RidgePoint& point, const V& touched, double R) {
  constexpr double close = 0.1;  // of the radius
  const V apart = node.point - touched;
  return node.feature == point.feature || dot(apart, apart) < close * close * R * R;
}

/// Overlaps of a node in about the direction of a point: with the same thing, with others beside it [m].
struct NodeDepths {
  double same = 0, beside = 0;
};

NodeDepths depths_of(std::span<const NodeContact> node, const RidgePoint& point, const V& touched, double R) {
  NodeDepths depths;
  for (const NodeContact& c : node) {
    double& depth = is_same(c, point, touched, R) ? depths.same : depths.beside;
    depth = std::max(depth, c.overlap * likeness(c.direction, point.direction));
  }
  return depths;
}

/// A node leaves a contact with the same thing to a point of its segment, but for what the other node has.
void leave_to(const RidgePoint& point, std::span<NodeContact> node, const V& touched, double R,
              double other_has) {
  for (NodeContact& c : node) {
    if (!is_same(c, point, touched, R)) continue;
    const double left = point.seen * likeness(c.direction, point.direction) * (1 - std::min(1.0, other_has));
    c.share = std::min(c.share, 1 - left);
  }
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
    own.share = 0;
    const double overlap = R - own.distance;
    const V touched = along(segment, own.place) + own.distance * own.direction;
    const NodeDepths begin = depths_of(ends.begin, own, touched, R), end = depths_of(ends.end, own, touched, R);
    const double shadow =
        std::max({(1 - own.place) * begin.beside + own.place * end.beside,
                  near(own.place * length, R) * begin.beside, near((1 - own.place) * length, R) * end.beside,
                  std::min(begin.same, end.same)});
    leave_to(own, ends.begin, touched, R, hertz(end.same / overlap));
    leave_to(own, ends.end, touched, R, hertz(begin.same / overlap));
    if (!(shadow < overlap)) continue;
    own.share = own.seen * part_of_group(own, points, length, R) * (1 - hertz(shadow / overlap)) *
                share_at(mesh, own, segment.begin, segment.end, segment.before, even) *
                share_at(mesh, own, segment.end, segment.begin, segment.behind, even);
  }
}

}  // namespace fiberchain::dem
