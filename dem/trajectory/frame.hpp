#pragma once

#include <cstdint>
#include <vector>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A bond at one moment.
struct FrameBond {
  std::int64_t first;    ///< sphere; the other is first + 1
  Vec<double, 3> force;  ///< on the first sphere [N]
  double bending_angle;  ///< between the orientations of its spheres [rad]
};

/// All spheres at one moment, fiber after fiber.
struct TrajectoryFrame {
  double time;  ///< [s]
  std::int64_t step;
  Vec<double, 3> low, high;  ///< of the box that is shown, or the periodic cell [m]
  bool periodic[3];
  std::vector<Vec<double, 3>> position, velocity;  ///< [m], [m/s]
  std::vector<double> radius;                      ///< [m]
  std::vector<std::int32_t> fiber;                 ///< number of the fiber
  std::vector<FrameBond> bonds;
  std::int64_t absent = 0;                 ///< spheres at the end that are inserted later
  std::vector<std::int64_t> missing = {};  ///< spheres before them that found no room, rising
};

/// The frame without its absent spheres and their bonds.
TrajectoryFrame present_part(TrajectoryFrame frame);

}  // namespace fiberchain::dem
