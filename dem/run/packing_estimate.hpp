#pragma once

#include <cstdint>

#include "dem/scene/build_packing.hpp"

// What a packing will take, from its numbers of spheres alone: nothing is inserted, nothing is run.
namespace fiberchain::dem {

/// Pairs in the neighbor list, and contacts, of a sphere of a dense packing of fibers: what estimates assume.
inline constexpr double assumed_pairs = 4, assumed_contacts = 1.5;

/// Memory by part [bytes].
struct PackingMemory {
  double spheres;        ///< position, radius, velocity and spin, orientation where followed
  double bonds;          ///< strain history, loads of the last step where energy is accounted
  double neighbor_list;  ///< reference positions, sorted cells, pairs
  double contacts;       ///< histories
  double start;          ///< states that fibers start from, freed before the first step
  double output;         ///< buffers of a frame and a checkpoint, freed in between
};
PackingMemory memory_of(const PackingScene& scene);

/// Peak: what stays, and the larger of what comes and goes.
double peak(const PackingMemory& memory);

/// Sizes of files [bytes].
struct PackingFileSizes {
  double trajectory;   ///< before compression
  double checkpoints;  ///< the last two
  double log;
  double vtk;  ///< 0 where not asked for
};
PackingFileSizes file_sizes_of(const PackingScene& scene, std::int64_t steps);

/// Time of a step.
struct StepCost {
  double per_sphere;     ///< [s]
  std::int64_t spheres;  ///< that it was measured on
  int threads;
};

/// Marches a dense stack of parallel straight fibers of the scene's first kind for some `seconds`, each
/// sphere in four contacts, with the scene's gravity, fluid and contact law; walls and periods are left out.
StepCost measure_step_cost(const PackingScene& scene, double step, int threads, double seconds = 0.05);

/// Sum over the steps of the spheres present: batches come one by one.
double sphere_steps_of(const PackingScene& scene, const PackingPlan& plan);

}  // namespace fiberchain::dem
