#pragma once

#include <vector>

#include "compare/bench/problems.hpp"
#include "dem/record/table.hpp"
#include "dem/scene/packing_scene.hpp"

namespace fiberchain::compare {

/// Time of a packing in one window of its steps [ns a sphere-step] and its memory.
struct PackingTime {
  std::int64_t spheres;
  int threads;
  std::int64_t from, to;     ///< steps
  double contacts_a_sphere;  ///< at the end
  double all, bonds, motion, contacts,
      search;             ///< one loop does bonds and motion; `motion` is that of one without bonds
  double output;          ///< frames of the trajectory, as often as the scene says
  double bytes_a_sphere;  ///< of the process, grown since before; 0 where the system does not say
};

/// `scene` from its start, window by window on one thread and on two; then pieces of it from a tenth of its
/// fibers to ten of it side by side, one thread. Fibers must come from a file, in a room whose first side
/// walls stand across x.
std::vector<PackingTime> packing_times(const dem::PackingScene& scene, const BenchOptions& options);

dem::Table packing_time_table(const std::vector<PackingTime>& times);

}  // namespace fiberchain::compare
