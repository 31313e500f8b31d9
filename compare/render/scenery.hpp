#pragma once

#include <array>
#include <span>
#include <vector>

#include "compare/render/ray_trace.hpp"
#include "dem/trajectory/frame.hpp"
#include "dem/trajectory/wall_surface.hpp"

/// What stands around fibers in a picture: walls where they are in a frame, within the box that is shown.
namespace fiberchain::compare {

struct Bounds {
  Point low, high;
};

/// The box around all that these frames show: spheres and walls of some extent (planes have none), periodic
/// cells whole; its sides are the scene's where they come near.
Bounds shown_bounds(std::span<const dem::TrajectoryFrame> frames, const std::vector<dem::WallSurface>& walls);

/// The same of two.
Bounds joined(const Bounds& a, const Bounds& b);

struct Scenery {
  std::vector<std::array<Point, 3>> facets;  ///< seen through
  std::vector<std::array<Point, 3>> floor;   ///< not seen through: at the bottom of the box, facing up
  std::vector<std::array<Point, 2>> edges;   ///< rims and sharp edges, and those of a periodic cell
};

/// Of the walls that are there, cut to the box.
Scenery scenery_of(const dem::TrajectoryFrame& frame, const std::vector<dem::WallSurface>& walls,
                   const Bounds& shown);

}  // namespace fiberchain::compare
