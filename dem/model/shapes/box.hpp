#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "dem/math/near_one.hpp"
#include "dem/model/shapes/nearest_point.hpp"
#include "dem/model/shapes/wall_pose.hpp"

namespace fiberchain::dem {

/// A solid box among fibers. Faces, edges and corners are one surface, which a sphere touches in one point:
/// the nearest, whose direction turns steadily as the sphere goes around an edge.
template <class Real>
struct BasicBoxObstacle {
  static constexpr std::string_view name = "box obstacle";

  Vec<Real, 3> point;          ///< the center at t = 0 [m]
  Vec<Real, 3> half;           ///< half of its sides [m]
  Vec<Real, 3> along, across;  ///< unit vectors along its first and second sides, perpendicular

  /// Of a point at `from` from `point` [m]. Inside, that of the nearest face.
  NearestPoint<Real> nearest(const Vec<Real, 3>& from) const {
    using std::max;
    using std::min;
    using std::sqrt;
    const Vec<Real, 3> third = cross(along, across);
    const Vec<Real, 3> own{dot(from, along), dot(from, across), dot(from, third)};
    const Real zero(0.0), one(1.0);
    Vec<Real, 3> sign, beyond, out;
    for (int c = 0; c < 3; ++c) {
      sign[c] = select(own[c] < zero, Real(-1.0), one);
      beyond[c] = sign[c] * own[c] - half[c];
      out[c] = max(beyond[c], zero);
    }
    const Real far = sqrt(max(dot(out, out), Real(1e-300)));
    const Real deepest = max(beyond[0], max(beyond[1], beyond[2]));
    const auto outside = deepest > Real(1e-140);
    const Real face0 = select(beyond[0] < deepest, zero, one);
    const Real face1 = (one - face0) * select(beyond[1] < deepest, zero, one);
    const Vec<Real, 3> face{face0, face1, one - face0 - face1};
    Vec<Real, 3> to;
    for (int c = 0; c < 3; ++c) to[c] = (zero - sign[c]) * select(outside, out[c] / far, face[c]);
    return {to[0] * along + to[1] * across + to[2] * third, select(outside, far, deepest)};
  }

  bool is_invariant_along(int) const { return false; }
  bool is_round_about(const Vec<double, 3>&, const Vec<double, 3>&) const { return false; }
  void turn(const Quaternion<double>& by) { along = rotate(by, along), across = rotate(by, across); }
};

using BoxObstacle = BasicBoxObstacle<double>;

}  // namespace fiberchain::dem
