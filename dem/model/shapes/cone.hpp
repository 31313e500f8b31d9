#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "dem/model/shapes/nearest_point.hpp"
#include "dem/model/shapes/wall_pose.hpp"

namespace fiberchain::dem {

/// The shell of a finite cone, cut off or not, open at both ends: a funnel, a hopper's outlet; with equal
/// radii a tube, without length a disk or ring. Fibers touch it from inside and from outside, and its rims,
/// each of which is rounded by half of the shell's thickness.
template <class Real>
struct BasicCone {
  static constexpr std::string_view name = "cone";

  Vec<Real, 3> point;     ///< of the axis at the first rim, at t = 0 [m]
  Vec<Real, 3> axis;      ///< unit vector from the first rim's center to the second's
  Real length;            ///< from rim to rim along the axis [m]
  Real radius;            ///< of the first rim, of the middle of the shell [m]
  Real end_radius;        ///< of the second [m]
  Real half = Real(0.0);  ///< half of the thickness [m]

  /// Of a point at `from` from `point` [m]: in the half plane of axis and point the shell is a straight
  /// segment. On the axis a direction across it is zero.
  NearestPoint<Real> nearest(const Vec<Real, 3>& from) const {
    using std::max;
    using std::min;
    using std::sqrt;
    const Real along = dot(from, axis), wider = end_radius - radius;
    const Vec<Real, 3> out = from - along * axis;
    const Real off = sqrt(max(dot(out, out), Real(1e-300)));
    const Real share =
        min(max((along * length + (off - radius) * wider) / (length * length + wider * wider), Real(0.0)),
            Real(1.0));
    const Real to_along = share * length - along, to_out = radius + share * wider - off;
    const Real far = sqrt(max(to_along * to_along + to_out * to_out, Real(1e-300)));
    return {(to_along / far) * axis + (to_out / (far * off)) * out, far - half};
  }

  bool is_invariant_along(int) const { return false; }
  bool is_round_about(const Vec<double, 3>& place, const Vec<double, 3>& line) const {
    return is_one_line(place, line, point, axis, radius + end_radius);
  }
  void turn(const Quaternion<double>& by) { axis = rotate(by, axis); }
};

using Cone = BasicCone<double>;

}  // namespace fiberchain::dem
