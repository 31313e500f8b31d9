#pragma once

#include <hdf5.h>

#include <vector>

#include "dem/trajectory/frame.hpp"
#include "dem/trajectory/wall_surface.hpp"

// Walls of a trajectory, where there are any: their surfaces once, where they are in time.
//
//   /parameters/walls/N            wall N, from 1: attribute "shape"; points [m], triangles of these
//   /parameters/walls/pose         in time, a row a wall: offset [m], turn (quaternion, w first), whether it
//   is
//                                  there; a point x of the surface is at turn x + offset
namespace fiberchain::dem::h5md {

inline constexpr const char* kWalls = "parameters/walls";
inline constexpr const char* kWallPoses = "parameters/walls/pose";
inline constexpr int wall_pose_size = 8;

bool has_walls(hid_t file);
void write_wall_surfaces(hid_t file, const std::vector<WallSurface>& walls);
std::vector<WallSurface> read_wall_surfaces(hid_t file);
/// Numbers of the poses of a frame, into memory that is kept.
void pose_numbers(const TrajectoryFrame& frame, std::vector<double>& numbers);
void set_poses(const std::vector<double>& numbers, TrajectoryFrame& frame);

}  // namespace fiberchain::dem::h5md
