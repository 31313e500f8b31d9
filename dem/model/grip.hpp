#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "dem/model/domain.hpp"

namespace fiberchain::dem {

/// A sphere of the fibers of an assembly.
struct SphereAddress {
  int group = 0, fiber = 0, sphere = 0;

  bool operator==(const SphereAddress&) const = default;
};

/// What takes hold of some spheres, as a rigid body that moves as walls do, or loads them. Components of
/// their places and rotations follow it from where they are when it comes; the others are free.
struct Grip {
  Wall body{.shape = Plane{}};  ///< name, time and motion of it; its shape means nothing, no force drives it
  std::array<bool, 3> place{};  ///< held along x, y, z
  std::array<bool, 3> turn{};   ///< held about x, y, z
  Vec<double, 3> force{}, moment{};  ///< on each of the spheres beside [N], [N m]
  double ramp = 0;                   ///< in which force and moment rise when it comes [s]
  std::vector<SphereAddress> spheres = {};

  bool holds() const {
    const auto any = [](const std::array<bool, 3>& axes) { return axes[0] || axes[1] || axes[2]; };
    return any(place) || any(turn);
  }
  bool loads() const { return norm(force) > 0 || norm(moment) > 0; }

  /// Part of force and moment at a time: smooth from 0 to 1 within the ramp, 0 while it is not there.
  double load_at(double time) const {
    if (!is_active(body, time)) return 0;
    if (!(ramp > 0)) return 1;
    const double x = std::min(1.0, (time - body.active_from) / ramp);
    return x * x * (3 - 2 * x);
  }
};

}  // namespace fiberchain::dem
