#pragma once
#include <cmath>
#include <string_view>

#include "dem/model/shapes/nearest_point.hpp"

namespace extensions {
using namespace fiberchain::dem;

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
};
using SphereWall = BasicSphereWall<double>;

}  // namespace extensions
