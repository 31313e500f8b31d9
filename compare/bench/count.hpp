#pragma once

#include "compare/bench/counted.hpp"
#include "dem/motion/physics.hpp"

namespace fiberchain::compare {

/// Operations of a bond-step of this physics in the motion of swinging_chain.hpp: mean over its bonds and
/// steps, the end loads and the iterations of the solvers along the chain among them; what is made of
/// constants and parameters alone is not. Throws dem::InvalidInput for a physics that is not built.
OperationCount operations_of_bond_step(const dem::Physics& physics);

}  // namespace fiberchain::compare
