#pragma once

#include <mpi.h>

#include <string>

#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem::mpi {

struct BenchOptions {
  std::int64_t after = 0;     ///< steps before what is measured
  std::int64_t steps = 1000;  ///< of each measurement
  int copies = 10;            ///< side by side, of the largest scene on one rank
  int rounds = 3;             ///< the fastest of them counts
};

/// On rank 0 a table in Markdown, elsewhere nothing: a sphere-step of the scene and of copies of it side by
/// side by the engine of one machine on one core, by one rank, and by 2, 4, ... ranks of `world`, of the same
/// spheres (strong) and of as many each (weak). Ranks that do not take part sleep.
/// Fibers must come from files, in a room whose first side walls stand across x.
/// @throws InvalidKey for a scene that is not such, or not carried over ranks
std::string scaling_table(MPI_Comm world, const PackingScene& scene, const BenchOptions& options);

}  // namespace fiberchain::dem::mpi
