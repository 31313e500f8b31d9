#pragma once

#include "dem/math/quaternion.hpp"
#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// Where a wall stands: turned about `center`, then shifted. What lay at x lies at
/// center + turn (x - center) + shift.
struct WallPose {
  Vec<double, 3> center{};  ///< at t = 0 [m]; of moments, too
  Vec<double, 3> shift{};   ///< [m]
  Quaternion<double> turn{1, {}};
  bool turned = false;  ///< `turn` is not the identity

  /// Where the center is now [m].
  Vec<double, 3> center_now() const { return center + shift; }
};

/// A shape where its wall stands.
template <class Shape>
Shape moved(Shape shape, const WallPose& pose) {
  if (pose.turned) {
    shape.point = pose.center + rotate(pose.turn, shape.point - pose.center);
    shape.turn(pose.turn);
  }
  shape.point = shape.point + pose.shift;
  return shape;
}

/// Whether a line through `place` along the unit vector `line` is one through `point` along `axis`, to
/// round-off over `size` [m].
inline bool is_one_line(const Vec<double, 3>& place, const Vec<double, 3>& line, const Vec<double, 3>& point,
                        const Vec<double, 3>& axis, double size) {
  constexpr double round_off = 1e-12;
  const Vec<double, 3> between = point - place;
  return norm(cross(line, axis)) < round_off &&
         norm(cross(between, line)) <= round_off * (size + norm(between));
}

}  // namespace fiberchain::dem
