#pragma once

#include <string>
#include <vector>

#include "compare/bench/problems.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/packing_scene.hpp"

namespace fiberchain::compare {

/// Time of a packing whose walls are given one way or another.
struct MeshTime {
  std::string walls;
  std::int64_t triangles;
  std::int64_t spheres;
  std::int64_t at_walls;  ///< contacts with walls, at the end
  double all;             ///< median of its windows [ns a sphere-step]
  double ratio;           ///< to the first: median over the windows, each beside that of the first
};

/// `scene`, which has a box of walls alone, once it has fallen: goes on with these walls, and with the same
/// box as meshes of some 1000 and 100 000 triangles, in turns, window by window, on one thread.
std::vector<MeshTime> mesh_times(const dem::PackingScene& scene, const BenchOptions& options);

dem::Table mesh_time_table(const std::vector<MeshTime>& times);

}  // namespace fiberchain::compare
