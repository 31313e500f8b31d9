#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/flow/history.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/scene.hpp"

// One fiber in a flow, as a scene asks for it: its run, and the tables and figures that show it.
namespace fiberchain::compare {

/// Throws dem::InvalidInput.
FlowHistory run_flow(const dem::FlowScene& scene);

/// Equivalent aspect ratio r_e of the rigid chain, by which orbit constants are taken; NaN beyond 500 spheres
/// that interact.
double scene_aspect_ratio(const dem::FlowScene& scene);

/// One row: what was asked, period, orbit constant, bending and what it took.
dem::Table flow_table(const dem::FlowScene& scene, const FlowHistory& history);

/// A row a moment.
dem::Table flow_history_table(const dem::FlowScene& scene, const FlowHistory& history);

/// A row a sphere and recorded moment.
dem::Table flow_shapes_table(const dem::FlowScene& scene, const FlowHistory& history);

/// "-shapes" and "-history" by the end of their names.
std::vector<std::pair<std::string, Figure>> flow_scene_figures(const dem::FlowScene& scene,
                                                               const FlowHistory& history);

}  // namespace fiberchain::compare
