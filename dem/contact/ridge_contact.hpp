#pragma once

#include <span>
#include <vector>

#include "dem/contact/segment_geometry.hpp"
#include "dem/mesh/mesh_contact.hpp"
#include "dem/mesh/mesh_ridges.hpp"

// Where a segment of a smooth fiber touches a mesh between its ends: the edges and corners that stand out.
// Flat faces and what falls in are touched by the nodes, as planes are.
namespace fiberchain::dem {

/// The point of a ridge, or of the corner where it ends, that is closest to a segment between its ends.
struct RidgePoint {
  std::int32_t feature;      ///< of the mesh
  double place;              ///< along the segment, above 0 and below 1
  Vec<double, 3> direction;  ///< unit vector from there to the mesh
  double distance;           ///< [m]
  double seen;               ///< 1; less where the mesh is nearer beside it, 0 where it is much
  double share = 0;          ///< of a contact (share_out())
};

/// Those nearer than `reach` [m] among these edges, to `found` by rising feature; nodes in the frame of the
/// mesh. Of a mesh of one side those seen from outside. Returns the least distance of the segment from any of
/// these edges [m]; infinite if there are none.
double find_ridge_points(const TriangleMesh& mesh, const MeshRidges& ridges, MeshSides sides,
                         std::span<const std::int32_t> edges, const SegmentNodes<double>& segment,
                         double reach, std::vector<RidgePoint>& found);

/// The closest point of one feature, wherever on the segment.
RidgePoint ridge_point(const TriangleMesh& mesh, std::int32_t feature, const SegmentNodes<double>& segment);

/// Angle [rad] by which a body is tilted over a ridge against what its nodes lie on, from which on both are
/// contacts of their own. Shares follow from where things lie, not from how deep they are pressed in: so a
/// blow loses or gains nothing by them.
inline constexpr double ridge_tilt = 0.1;

/// What a node touches of the mesh, or nearly: by less than ridge_tilt times the longer of its segments and
/// the diameter.
struct NodeContact {
  std::int32_t feature;
  Vec<double, 3> direction;  ///< unit vector to the mesh
  Vec<double, 3> point;      ///< of the mesh [m]
  double distance;           ///< [m]
  double share = 1;          ///< of a contact (share_out())
};

/// Those of both ends of a segment.
struct EndContacts {
  std::span<NodeContact> begin, end;
};

/// Shares of contacts, so that a straight body has one contact with a ridge wherever its nodes are, and the
/// force goes over steadily from ridge to ridge, from segment to segment and to the nodes:
/// - points of a segment nearer to each other than its diameter share the largest of their forces F alone,
///   F_max/(F_1 + F_2 + ...) each; at a joint that is bent around the mesh both segments share.
/// - A node that is nearest to the ridge itself, beside the point of its segment, leaves the contact to that;
///   where a segment lies along a ridge, as both nodes do, the nodes bear it.
/// - Beside a node that lies on something else, nearer than half a diameter (half a segment where that is
///   shorter), a point has no share unless the segment is tilted; nor between two such nodes.
void share_out(const TriangleMesh& mesh, const SegmentNodes<double>& segment, const EndContacts& ends,
               std::span<RidgePoint> points);

}  // namespace fiberchain::dem
