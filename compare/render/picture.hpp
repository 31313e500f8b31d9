#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/render/color_scale.hpp"
#include "compare/render/ray_trace.hpp"
#include "compare/render/scenery.hpp"
#include "compare/render/shade.hpp"
#include "dem/record/provenance.hpp"
#include "dem/trajectory/frame.hpp"

/// Pictures of many fibers as the paper's Fig 11.
namespace fiberchain::compare {

struct PictureOptions {
  std::string shade = "vertical_speed";  ///< what the color of a fiber tells
  std::optional<std::pair<double, double>> range =
      std::nullopt;                            ///< of the color scale; without it, from the data
  std::optional<Bounds> shown = std::nullopt;  ///< without it, around what is there
  std::vector<dem::WallSurface> walls = {};
  View view = {};
  int width = 1280, height = 800;  ///< [pixels]
  int threads = 1;
};

struct Picture {
  std::string png;
  std::pair<double, double> range;   ///< of the color scale
  std::size_t below = 0, above = 0;  ///< spheres beyond its ends, which marks at them tell of
};

/// The frame as PNG: fibers, walls, box, color scale with its unit, time; provenance as tEXt chunks.
/// @throws FigureError if gnuplot, which sets the texts, is missing or refuses
Picture draw(const dem::TrajectoryFrame& frame, const PictureOptions& options,
             const dem::Provenance& provenance);

/// Some frames in two columns, (a), (b), ..., under one color scale; width and height are those of all
/// together.
/// @throws FigureError as draw()
Picture draw_sheet(const std::vector<dem::TrajectoryFrame>& frames, const PictureOptions& options,
                   const dem::Provenance& provenance);

}  // namespace fiberchain::compare
