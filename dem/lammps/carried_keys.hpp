#pragma once

#include "dem/chain/chain.hpp"
#include "dem/scene/packing_scene.hpp"

// What of a scene this engine does not carry: refused by name, never left out.
namespace fiberchain::dem::mpi {

/// That rank 0 gathers for files.
inline constexpr std::int64_t most_spheres = 10'000'000;

/// @throws InvalidKey for the first key that asks for what is not built here
void refuse_what_is_not_carried(const PackingScene& scene);

/// @throws InvalidKey for a chain with corners
void refuse_chain(const Chain<3>& chain);

}  // namespace fiberchain::dem::mpi
