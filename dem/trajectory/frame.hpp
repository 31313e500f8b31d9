#pragma once

#include <cstdint>
#include <vector>

#include "dem/math/quaternion.hpp"
#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A bond at one moment.
struct FrameBond {
  std::int64_t first;    ///< sphere; the other is first + 1
  Vec<double, 3> force;  ///< on the first sphere [N]
  double bending_angle;  ///< between the orientations of its spheres [rad]
};

/// What touches. The numbers stand in files.
enum class ContactKind : std::uint8_t { fibers = 0, wall = 1, same_fiber = 2 };

/// A contact at one moment.
struct FrameContact {
  std::int64_t first;   ///< sphere
  std::int64_t second;  ///< sphere; of a wall its number, from 1
  ContactKind kind;
  Vec<double, 3> point;   ///< [m]
  Vec<double, 3> normal;  ///< from the first sphere to the second body
  Vec<double, 3> force;   ///< on the first sphere [N]
};

/// Where a wall is at one moment: what lay at x when it was put there lies at turn x + offset.
struct FrameWall {
  Vec<double, 3> offset{};  ///< [m]
  Quaternion<double> turn{1, {}};
  bool is_there = true;
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
  bool has_contacts = false;               ///< they are known
  std::vector<FrameContact> contacts = {};
  std::vector<FrameWall> walls = {};
  bool walls_as_before = false;  ///< none has moved, come or gone since the frame before
};

/// The frame without its absent spheres and their bonds.
TrajectoryFrame present_part(TrajectoryFrame frame);

}  // namespace fiberchain::dem
