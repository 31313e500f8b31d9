#pragma once

#include "compare/figures/figure.hpp"
#include "dem/record/table.hpp"
#include "dem/run/run_fiber.hpp"

/// A rod's path of equilibria, and the tables and figures that show it.
namespace fiberchain::compare {

struct RodRun {
  dem::RodResult result;
  double run_time;  ///< [s]
};

/// @throws dem::InvalidInput, dem::NoConvergence
RodRun run_rod(const dem::RodScene& scene);

/// One row: what was asked, where the path or its branch ends, what is singular on the way.
dem::Table rod_table(const dem::RodScene& scene, const RodRun& run);

/// A row per path point and singular point, in order.
dem::Table rod_path_table(const dem::RodScene& scene, const RodRun& run);

/// A row per sphere of so many points of the path and of the branch as the scene asks for, and of singular
/// points.
dem::Table rod_shapes_table(const dem::RodScene& scene, const RodRun& run);

/// Load factor over the probe's displacement, singular points marked.
Figure rod_path_figure(const dem::RodScene& scene, const RodRun& run);

/// Some shapes in the x-y plane.
Figure rod_shapes_figure(const dem::RodScene& scene, const RodRun& run);

}  // namespace fiberchain::compare
