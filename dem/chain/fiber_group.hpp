#pragma once

#include <vector>

#include "dem/chain/chain_state.hpp"

namespace fiberchain::dem {

/// Fibers of one kind and their initial states.
struct FiberGroup {
  Chain<3> chain;                     ///< with `natural` where curved at rest
  std::vector<ChainState<3>> fibers;  ///< one state a fiber
};

}  // namespace fiberchain::dem
