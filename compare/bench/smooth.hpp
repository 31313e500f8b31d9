#pragma once

#include <string>
#include <vector>

#include "compare/bench/problems.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/packing_scene.hpp"

namespace fiberchain::compare {

/// Time of a packing whose fibers have one surface or another.
struct SmoothTime {
  std::string surface;  ///< spheres or smooth
  double spacing;       ///< of the nodes, over the diameter
  std::int64_t spheres, contacts;
  double chosen_step;  ///< where the scene gives none [s]
  double sphere_step;  ///< median of its windows [ns]
  double ratio;        ///< of the windows to those of the first, all with the same number of steps: median
};

/// `scene` with fibers that touch by their spheres, with smooth ones, and with smooth ones of fewer nodes,
/// each once it has fallen with a
/// step that all bear: goes on in turns, window by window, on one thread.
std::vector<SmoothTime> smooth_times(const dem::PackingScene& scene, const BenchOptions& options);

dem::Table smooth_time_table(const std::vector<SmoothTime>& times);

}  // namespace fiberchain::compare
