#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dem/model/domain.hpp"
#include "dem/trajectory/frame.hpp"

// Walls as triangles, for viewers.
namespace fiberchain::dem {

/// A wall where it stands at t = 0, unmoved. Frames have where it is then (FrameWall).
struct WallSurface {
  std::string shape;                                   ///< name of its kind
  std::vector<Vec<double, 3>> points;                  ///< [m]
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< numbers of points
};

/// Of all walls, each of any kind. Planes and cylinders, which are endless, are cut to the box between `low`
/// and `high` and around the walls that have an extent; planes also to the cylinders that fibers are inside
/// of, whose ends they close. A plane that does not meet the box has its size. Round ones deviate by 0.2 % of
/// their radius. A wall of a kind that is not known here has no triangles.
std::vector<WallSurface> wall_surfaces(const std::vector<Wall>& walls, const Vec<double, 3>& low,
                                       const Vec<double, 3>& high);

/// Where it is at a time. One that is driven is where it is now, whatever the time.
FrameWall frame_wall(const Wall& wall, double time);

/// The point of a wall's surface now.
inline Vec<double, 3> placed_at(const FrameWall& wall, const Vec<double, 3>& point) {
  return rotate(wall.turn, point) + wall.offset;
}

}  // namespace fiberchain::dem
