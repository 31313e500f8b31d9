#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/render/ray_trace.hpp"
#include "dem/record/provenance.hpp"
#include "dem/trajectory/frame.hpp"

/// Pictures of many fibers as the paper's Fig 11.
namespace fiberchain::compare {

/// What the color of a fiber tells.
enum class Shade {
  vertical_speed,  ///< z component of the velocity [m/s]
  bending_angle    ///< of the bonds, at a sphere the mean of its two [rad]
};

struct PictureOptions {
  Shade shade = Shade::vertical_speed;
  std::optional<std::pair<double, double>> range =
      std::nullopt;  ///< of the color scale; without it, from the data
  View view = {};
  int width = 1280, height = 800;  ///< [pixels]
  int threads = 1;
};

/// A number for each sphere of the frame.
std::vector<double> shade_of(const dem::TrajectoryFrame& frame, Shade shade);

inline constexpr int kColors = 64;

/// Color of a value, 0 for the lowest to kColors - 1: what is beyond the scale has the color of its end, NaN
/// the lowest.
int palette_place(double value, const std::pair<double, double>& range);

/// Ends of the color scale: those of the data without its lowest and highest half percent, which show in the
/// end colors.
std::pair<double, double> range_of(std::vector<double> values);

/// Those of all these frames.
std::pair<double, double> shade_range(std::span<const dem::TrajectoryFrame> frames, Shade shade);

struct Picture {
  std::string png;
  std::pair<double, double> range;  ///< of the color scale
};

/// The frame as PNG: fibers, box, color scale with its unit, time; provenance as tEXt chunks.
/// @throws FigureError if gnuplot, which sets the texts, is missing or refuses
Picture draw(const dem::TrajectoryFrame& frame, const PictureOptions& options,
             const dem::Provenance& provenance);

/// Some frames in two columns, (a), (b), ..., under one color scale; width and height are those of all
/// together.
/// @throws FigureError as draw()
Picture draw_sheet(const std::vector<dem::TrajectoryFrame>& frames, const PictureOptions& options,
                   const dem::Provenance& provenance);

}  // namespace fiberchain::compare
