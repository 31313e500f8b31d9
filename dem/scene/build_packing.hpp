#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dem/scene/packing_scene.hpp"

// From a scene of many fibers to what dem::Assembly takes.
namespace fiberchain::dem {

/// The kind's rest shape.
Chain<3> chain_of(const PackingFiberKind& kind);

/// Time step and length of a packing, which follow from its kinds of fibers alone.
struct PackingPlan {
  StepChoice choice;   ///< step taken where the scene gives none, and what sets it
  double step;         ///< [s]
  std::int64_t steps;  ///< of the whole run
  Integrator integrator = Integrator::leapfrog;
};

/// What a step with bonds solved for costs in steps without, at the few contacts that packings of fibers have
/// (measured, bench --case stiff: 3.4 to 3.8 where none touch, 1.7 with four contacts a sphere).
inline constexpr double stiff_step_cost = 3;

/// @throws InvalidInput for a run of no steps or of too many, and for batches that would never come
PackingPlan plan_of(const PackingScene& scene);

/// Threads that are worth synchronizing every step, at most as many as given.
int useful_threads(const PackingScene& scene, int threads);

/// What an assembly starts from.
struct PackingStart {
  std::vector<FiberGroup> groups;  ///< those carried, those of files, then the first batch of those at random
  Domain domain;
  AssemblyOptions options;  ///< with the step
  StepChoice choice;        ///< the step that is taken where the scene gives none, and what sets it
  std::int64_t steps;       ///< of the whole run
};

/// Fibers that a packing goes on with.
struct CarriedStart {
  std::vector<FiberGroup> groups = {};  ///< as `carried` of the scene says
  double time = 0;                      ///< that the scene begins at [s]
};

/// Small scenes take fewer threads than given: waiting for each other would cost them more.
/// @throws InvalidInput for what makes no sense together, NoRoom when fibers do not go into the region
PackingStart packing_start(const PackingScene& scene, int threads, const InsertionWatch& watch = {},
                           const CarriedStart& carried = {});

/// The assembly itself.
/// @throws InvalidInput also for spheres beyond a wall
Assembly make_assembly(PackingStart start);

/// Steps after which batch `n` comes, 0 for the first.
std::int64_t batch_step(const PackingScene& scene, int n, double step);

/// How many fibers of which kind batch `n` has, in the order of their groups.
std::vector<InsertionCount> batch_counts(const PackingScene& scene, int n);

/// Groups of fibers at the start: those that were there, those of files and of the first batch.
int groups_at_start(const PackingScene& scene);

/// The kind of each group that is there; `inserted` has the fibers of each group that came after the start.
std::vector<std::int64_t> kinds_of_groups(const PackingScene& scene,
                                          const std::vector<std::int64_t>& inserted);

/// What holds and loads spheres of the fibers that are there at the start.
/// @throws InvalidKey for a fiber that is not
std::vector<Grip> grips_of(const PackingScene& scene);

/// The fibers of batch `n`, beside those that are there, among the walls of that time [s]. Kinds without a
/// fiber in it are left out.
/// @throws NoRoom, unless fewer fibers are accepted: groups may then be empty
std::vector<FiberGroup> packing_batch(const PackingScene& scene, int n, double time,
                                      const PlacedSpheres& present, const InsertionWatch& watch = {},
                                      Shortfall shortfall = Shortfall::refuse);

/// Fibers of all batches and files.
std::int64_t fibers_in(const PackingScene& scene);
std::int64_t spheres_in(const PackingScene& scene);

/// SHA-256 of everything the scene is made of: its text and the files it names.
std::string scene_fingerprint(const SceneText& text, const PackingScene& scene);

}  // namespace fiberchain::dem
