#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "dem/mesh/triangle_mesh.hpp"

// Where a sphere touches a mesh. Contacts are the least distances of its center from the surface, each one
// alone: the feature that holds the closest point of every triangle at it. A face counts where the center is
// over it, an edge or a corner where it is over no neighbor of it; so a sphere that rolls over an edge of a
// flat or convex place has one contact all the time, in a concave corner one with each face.
namespace fiberchain::dem {

/// From which sides fibers touch a mesh.
enum class MeshSides : std::uint8_t {
  both,  ///< it is a thin sheet
  one    ///< from outside, where normals point; a closed mesh is solid
};

/// Contacts whose directions differ by less are one, the nearer: facets of a curved surface. A face beyond
/// this angle comes into touch with no overlap, and so without a jump, unless overlaps are above 6 % of the
/// radius (1 - cos).
inline constexpr double smooth_cosine = 0.93969262078590838;  // 20 degrees

/// The closest point of a triangle, on one of its features.
struct ClosestPoint {
  std::int32_t feature;
  Vec<double, 3> to;  ///< from the center to it [m]
  double squared;     ///< distance [m^2]
};

ClosestPoint closest_point(const TriangleMesh& mesh, std::int32_t triangle, const Vec<double, 3>& center);

/// What no point of a triangle is nearer than, squared [m^2]; reads nothing but its plane.
double squared_distance_bound(const TriangleMesh& mesh, std::int32_t triangle, const Vec<double, 3>& center);

/// The closest point of a feature.
ClosestPoint closest_on_feature(const TriangleMesh& mesh, std::int32_t feature, const Vec<double, 3>& center);

/// The nearest point of all of the mesh.
ClosestPoint nearest_point(const TriangleMesh& mesh, const Vec<double, 3>& center);

/// Whether a center is on the outer side of the surface at its closest point.
bool is_outside(const TriangleMesh& mesh, const ClosestPoint& closest);

/// A unit vector to a closest point; through the surface where the center lies on it.
Vec<double, 3> direction_of(const TriangleMesh& mesh, const ClosestPoint& closest);

/// A place where a sphere touches one face and nothing else, however it moves a little.
struct FlatPlace {
  std::int32_t face = -1;         ///< -1: the place is not such
  bool alone = false;             ///< no other triangle is in reach
  Vec<double, 3> corner, normal;  ///< of the face's plane
  Vec<double, 3> center;          ///< of the sphere, ...
  double margin = 0;              ///< ... that may go so far from there [m]; 0: the place is not such
};

/// Where a center is over the inside of a face and every other of these triangles, which are all that may
/// come into reach, lies behind the face's plane, or farther than the face and in about its direction, or out
/// of reach: for as far as the center may go with that so.
FlatPlace flat_place(const TriangleMesh& mesh, std::span<const std::int32_t> triangles,
                     const Vec<double, 3>& center, double reach, double most);

struct MeshContact {
  std::int32_t feature;
  Vec<double, 3> direction;  ///< unit vector from the center to the mesh
  double distance;           ///< [m]; negative behind a mesh of one side
};

/// A triangle that a center is beside of.
struct BesideTriangle {
  std::int32_t triangle;
  int only_side;  ///< which it is beyond; -1 if there are two
};

/// With the face of a flat place: what find_mesh_contacts() finds there, to the bit, where is_told_by()
/// holds.
inline MeshContact contact_at(const FlatPlace& place, double height) {
  return {place.face, height < 0 ? place.normal : -place.normal, std::sqrt(height * height)};
}
inline double height_over(const FlatPlace& place, const Vec<double, 3>& center) {
  return dot(center - place.corner, place.normal);
}

/// How far over the plane of a flat place's face other triangles may reach there, over the reach.
inline constexpr double low_triangle = 0.02;

/// Whether a center that has gone no farther than its margin touches the face of a flat place or nothing.
/// What lies lower than low_triangle and within reach is seen in a direction that the least height here
/// bounds: one contact with the face's, as add_contact() has it.
inline bool is_told_by(const FlatPlace& place, MeshSides sides, double height, double reach) {
  if (!(height > 0) && (!place.alone || sides == MeshSides::one)) return false;
  return place.alone || height > (smooth_cosine + low_triangle) * reach;
}

/// Memory kept between calls.
struct MeshContactScratch {
  std::vector<ClosestPoint> points;
  std::vector<BesideTriangle> beside;
  std::vector<MeshContact> contacts;
};

/// Contacts of a sphere nearer than `reach` [m] among these triangles, to scratch.contacts by rising feature;
/// the triangles must be all within `reach`, and may be more. `held`: the sphere touched the outside of the
/// mesh the step before, so that it is pressed in where its center is behind an open mesh. Returns the least
/// distance from any of the triangles or less, where none touches [m]; infinite if there are none.
double find_mesh_contacts(const TriangleMesh& mesh, MeshSides sides, std::span<const std::int32_t> triangles,
                          const Vec<double, 3>& center, double reach, bool held, MeshContactScratch& scratch);

}  // namespace fiberchain::dem
