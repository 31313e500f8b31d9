#pragma once

#include "compare/bench_counted.hpp"
#include "dem/motion/physics.hpp"

namespace fiberchain::compare {

/// Operations of one step of a chain of `bonds` bonds, clamped at its first sphere, by this physics. The step's end loads
/// are among them. Throws dem::InvalidInput for a physics that is not built.
OperationCount operations_of_step(const dem::Physics& physics, int bonds);

}  // namespace fiberchain::compare
