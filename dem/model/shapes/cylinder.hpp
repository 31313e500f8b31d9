#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "dem/model/shapes/nearest_point.hpp"
#include "dem/model/shapes/wall_pose.hpp"

namespace fiberchain::dem {

/// The inside of an endless cylinder, or the outside of one.
template <class Real>
struct BasicCylinder {
  static constexpr std::string_view name = "cylinder";

  Vec<Real, 3> point;     ///< of the axis at t = 0 [m]
  Vec<Real, 3> axis;      ///< unit vector
  Real radius;            ///< [m]
  Real side = Real(1.0);  ///< 1: fibers are inside, -1: outside

  /// Of a point at `from` from `point` [m]: along the ray from the axis. On the axis itself the direction is
  /// zero.
  NearestPoint<Real> nearest(const Vec<Real, 3>& from) const {
    using std::max;
    using std::sqrt;
    const Vec<Real, 3> out = from - dot(from, axis) * axis;
    const Real distance = sqrt(max(dot(out, out), Real(1e-300)));
    return {(side / distance) * out, side * (radius - distance)};
  }

  bool is_invariant_along(int c) const { return std::abs(axis[c]) > 1 - 1e-12; }
  bool is_round_about(const Vec<double, 3>& place, const Vec<double, 3>& line) const {
    return is_one_line(place, line, point, axis, radius);
  }
  void turn(const Quaternion<double>& by) { axis = rotate(by, axis); }
};

using Cylinder = BasicCylinder<double>;

}  // namespace fiberchain::dem
