#pragma once

#include <memory>
#include <string_view>

#include "dem/mesh/mesh_contact.hpp"
#include "dem/model/domain.hpp"
#include "dem/model/shapes/nearest_point.hpp"

namespace fiberchain::dem {

/// A mesh as the shape of a wall. The mesh stays in its own frame; this says where that stands. Unlike other
/// shapes it may touch a sphere in several points, and its contacts are found by mesh_contact.hpp.
struct MeshShape {
  static constexpr std::string_view name = "mesh";

  std::shared_ptr<const TriangleMesh> mesh;
  MeshSides sides = MeshSides::both;
  Vec<double, 3> point{};               ///< of the mesh's origin at t = 0 [m]
  Quaternion<double> turned_by{1, {}};  ///< from the mesh's axes to those of space
  bool turned = false;                  ///< by more than nothing

  /// Of a point at `from` from `point` [m]. The distance is negative inside of a closed mesh of one side.
  NearestPoint<double> nearest(const Vec<double, 3>& from) const;

  bool is_invariant_along(int) const { return false; }
  bool is_round_about(const Vec<double, 3>&, const Vec<double, 3>&) const { return false; }
  void turn(const Quaternion<double>& by) { turned_by = normalized(by * turned_by), turned = true; }

  /// From space into the mesh's frame: places and directions, and back: directions.
  Vec<double, 3> to_mesh(const Vec<double, 3>& place) const {
    return turned ? rotate(conjugate(turned_by), place - point) : place - point;
  }
  Vec<double, 3> into_mesh(const Vec<double, 3>& direction) const {
    return turned ? rotate(conjugate(turned_by), direction) : direction;
  }
  Vec<double, 3> to_space(const Vec<double, 3>& direction) const {
    return turned ? rotate(turned_by, direction) : direction;
  }
  /// The nearest point of a feature, seen from a place in space; as nearest(), behind it where the place is.
  NearestPoint<double> nearest_of_feature(std::int32_t feature, const Vec<double, 3>& place) const;
};

/// The mesh of a wall; null where its shape is another one.
const MeshShape* mesh_in(const Wall& wall);

/// Whether the straight way between two places goes through a mesh wall where it stands at that time; never
/// through walls of other shapes.
bool passes_through(const Wall& wall, const Vec<double, 3>& from, const Vec<double, 3>& to, double time);

}  // namespace fiberchain::dem
