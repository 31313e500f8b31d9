#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "dem/model/shapes/nearest_point.hpp"
#include "dem/model/shapes/wall_pose.hpp"

namespace fiberchain::dem {

/// The inside of a sphere, or the outside of one.
template <class Real>
struct BasicSphere {
  static constexpr std::string_view name = "sphere";

  Vec<Real, 3> point;     ///< the center at t = 0 [m]
  Real radius;            ///< [m]
  Real side = Real(1.0);  ///< 1: fibers are inside, -1: outside

  /// Of a point at `from` from `point` [m]: along the ray from the center. At the center itself the direction
  /// is zero.
  NearestPoint<Real> nearest(const Vec<Real, 3>& from) const {
    using std::max;
    using std::sqrt;
    const Real distance = sqrt(max(dot(from, from), Real(1e-300)));
    return {(side / distance) * from, side * (radius - distance)};
  }

  bool is_invariant_along(int) const { return false; }
  bool is_round_about(const Vec<double, 3>& place, const Vec<double, 3>& line) const {
    return is_one_line(place, line, point, line, radius);
  }
  void turn(const Quaternion<double>&) {}
};

using Sphere = BasicSphere<double>;

}  // namespace fiberchain::dem
