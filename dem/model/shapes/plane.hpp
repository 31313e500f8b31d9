#pragma once

#include <cmath>
#include <string_view>

#include "dem/model/shapes/nearest_point.hpp"

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
};

using Plane = BasicPlane<double>;

}  // namespace fiberchain::dem
