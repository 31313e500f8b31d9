#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem/math/vec.hpp"

/// Solids drawn by ray tracing (Tachyon), without a display.
namespace fiberchain::compare {

using Point = dem::Vec<double, 3>;

struct Color {
  float red, green, blue;  ///< from 0 to 1
};

/// A cylinder between two points, or a sphere where they are the same.
struct Rod {
  Point from, to;
  double radius;
  int color;  ///< place in the palette
};

/// What is drawn: lengths in any one unit, z up.
struct Solids {
  std::vector<Rod> rods;
  std::vector<Color> palette;
  Point low, high;                                ///< box that is in the picture
  bool box = true;                                ///< its edges are shown
  std::vector<std::array<Point, 3>> facets = {};  ///< seen through
  std::vector<std::array<Point, 3>> floor = {};   ///< not seen through; without any the box has one
  std::vector<std::array<Point, 2>> edges = {};   ///< of what the facets show
};

/// Where the camera stands, seen from the middle of the box. Its distance is chosen so that the whole box is
/// in view.
struct View {
  double azimuth = -60;   ///< from the x axis, about z [degrees]
  double elevation = 18;  ///< above the floor [degrees]
};

/// Rows from the top, each from the left, three bytes a pixel.
struct Image {
  int width, height;
  std::vector<std::uint8_t> rgb;
};

/// @param threads that share the work; no more than the machine has are used
Image ray_trace(const Solids& solids, const View& view, int width, int height, int threads);

}  // namespace fiberchain::compare
