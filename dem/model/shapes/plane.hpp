#pragma once

#include <cmath>
#include <string_view>

#include "dem/model/shapes/nearest_point.hpp"
#include "dem/model/shapes/wall_pose.hpp"

namespace fiberchain::dem {

/// A wall that fills the half space behind it.
template <class Real>
struct BasicPlane {
  static constexpr std::string_view name = "plane";

  Vec<Real, 3> point;   ///< of the wall at t = 0 [m]
  Vec<Real, 3> normal;  ///< unit vector into the domain

  /// Of a point at `from` from `point` [m].
  NearestPoint<Real> nearest(const Vec<Real, 3>& from) const { return {-normal, dot(from, normal)}; }

  bool is_invariant_along(int axis) const { return std::abs(normal[axis]) < 1e-12; }
  bool is_round_about(const Vec<double, 3>&, const Vec<double, 3>& line) const {
    return norm(cross(normal, line)) < 1e-12;
  }
  void turn(const Quaternion<double>& by) { normal = rotate(by, normal); }
};

using Plane = BasicPlane<double>;

}  // namespace fiberchain::dem
