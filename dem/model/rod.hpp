#pragma once

#include <array>
#include <string_view>

#include "dem/math/quaternion.hpp"
#include "dem/math/vec.hpp"

// What holds a rod in space and what it bears.
namespace fiberchain::dem {

/// What a load does as its sphere turns.
enum class LoadDirection {
  dead,  ///< keeps its direction in space. A dead moment has no potential in space (in a plane it has one)
  following  ///< turns with its sphere. Such loads have no potential
};

constexpr std::string_view name(LoadDirection direction) {
  return direction == LoadDirection::dead ? "dead" : "following";
}

/// A force and a moment on one sphere: global axes where dead; where following those of the sphere, x along
/// the fiber, which are the global ones for the first member of a straight rest shape.
struct RodPointLoad {
  int sphere = 0;
  Vec<double, 3> force{};   ///< [N]
  Vec<double, 3> moment{};  ///< [N m]
  LoadDirection direction = LoadDirection::dead;
  bool steady = false;  ///< acts in full all along the path, else times the load factor
};

/// A force per length of the rod between two spheres; axes as of RodPointLoad, those of the bond's ends where
/// following.
struct RodLineLoad {
  int first = 0, last = 0;  ///< spheres, first < last
  Vec<double, 3> force{};   ///< [N/m]
  LoadDirection direction = LoadDirection::dead;
  bool steady = false;
};

/// What holds a sphere. Displacements are held along and turns about the support's axes, whose turn against
/// the global ones is `axes`. Turns with
///   three held: a clamp;
///   two held: a hinge about the third axis, fixed in space;
///   one held: a universal joint. Its outer axis is the next one in the order x, y, z, x and fixed in space,
///     its inner one the one after, carried by the outer: with x held the outer is y, the inner z;
///   none held: a ball.
/// Along the path the held displacements go with the load factor by `moved`, the turns by the rotation vector
/// `turned`, about the position and orientation that the sphere starts with; `turned` asks for a clamp.
struct RodSupport {
  int sphere = 0;
  std::array<bool, 3> hold_displacement{true, true, true};
  std::array<bool, 3> hold_rotation{true, true, true};
  Quaternion<double> axes{1, {0, 0, 0}};
  Vec<double, 3> moved{};   ///< [m] at load factor 1
  Vec<double, 3> turned{};  ///< [rad] at load factor 1, global axes
};

}  // namespace fiberchain::dem
