#pragma once

#include "dem/assembly/carried_state.hpp"
#include "dem/scene/packing_scene.hpp"

// A scene that goes on with the fibers of a file.
namespace fiberchain::dem {

/// The kinds of fibers without one: by diameter and number of spheres, for files that do not say.
/// @throws InvalidKey where none fits, or more than one
std::vector<std::int64_t> kinds_by_shape(const PackingScene& scene, const CarriedState& state);

/// The scene with the fibers of a state there already; those of its counts that the state does not have come
/// with the batches that are still due at its time, at once where none is.
/// @param kinds of each group of the state
/// @throws InvalidKey naming what does not go: diameter, aspect ratio, fewer fibers than there are
PackingScene carried_over(PackingScene scene, const CarriedState& state,
                          const std::vector<std::int64_t>& kinds);

/// The same of a checkpoint that a run after that wrote: pairs of kind and number, batches that were done.
/// @throws InvalidInput for kinds that the scene does not have
PackingScene carried_over(PackingScene scene, const std::vector<std::int64_t>& pairs,
                          std::int64_t batches_done);

/// Pairs of kind and number of each group.
std::vector<std::int64_t> pairs_of(const std::vector<CarriedFibers>& carried);

/// The groups with the scene's own chains.
std::vector<FiberGroup> groups_of(const PackingScene& scene, const CarriedState& state);

}  // namespace fiberchain::dem
