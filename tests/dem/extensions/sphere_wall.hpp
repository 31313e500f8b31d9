#pragma once
#include <cmath>
#include <string_view>

#include "dem/model/shapes/nearest_point.hpp"
#include "dem/model/shapes/wall_pose.hpp"

namespace extensions {
using namespace fiberchain::dem;
using V3 = Vec<double, 3>;

/// The outside of a sphere.
template <class Real>
struct BasicSphereWall {
  static constexpr std::string_view name = "sphere";
  Vec<Real, 3> point;  ///< center at t = 0 [m]
  Real radius;         ///< [m]

  NearestPoint<Real> nearest(const Vec<Real, 3>& from) const {
    using std::sqrt;
    const Real distance = sqrt(dot(from, from));
    return {(Real(-1.0) / distance) * from, distance - radius};
  }
  bool is_invariant_along(int) const { return false; }
  bool is_round_about(const V3&, const V3&) const { return false; }
  void turn(const Quaternion<double>&) {}
};
using SphereWall = BasicSphereWall<double>;

}  // namespace extensions
