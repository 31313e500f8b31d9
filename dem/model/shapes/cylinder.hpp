#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "dem/model/shapes/nearest_point.hpp"

namespace fiberchain::dem {

/// The inside of a cylinder.
template <class Real>
struct BasicCylinder {
  static constexpr std::string_view name = "cylinder";

  Vec<Real, 3> point;  ///< of the axis at t = 0 [m]
  Vec<Real, 3> axis;   ///< unit vector
  Real radius;         ///< [m]

  /// Of a point at `from` from `point` [m]: outward from the axis. On the axis itself the direction is zero.
  NearestPoint<Real> nearest(const Vec<Real, 3>& from) const {
    using std::max;
    using std::sqrt;
    const Vec<Real, 3> out = from - dot(from, axis) * axis;
    const Real distance = sqrt(max(dot(out, out), Real(1e-300)));
    return {(Real(1.0) / distance) * out, radius - distance};
  }

  bool is_invariant_along(int c) const { return std::abs(axis[c]) > 1 - 1e-12; }
};

using Cylinder = BasicCylinder<double>;

}  // namespace fiberchain::dem
