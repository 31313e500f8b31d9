#pragma once

#include "reference/linear_chain.hpp"

namespace fiberchain::reference {

/// Largest time step [s] at which leapfrog, with the dashpots' forces taken at the velocity half a step
/// earlier, does not let any small motion of an endless chain grow: for every wave,
/// M - (dt/2) C - (dt^2/4) K is positive definite. Axial, bending (with shear) and, unless the motion is
/// planar, twisting waves are looked at. A finite chain's waves are among these. Throws InvalidArgument.
double largest_stable_step(const LinearChain& chain, bool planar = false);

}  // namespace fiberchain::reference
