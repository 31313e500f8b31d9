#pragma once

#include "dem/model/fiber.hpp"
#include "reference/chain_modes.hpp"

// Rolling friction at small amplitude, worked out from the linear mode: no march.
namespace fiberchain::compare {

/// What rolling friction adds to xi_f, over xi_r a/L, where the friction is weak and the amplitude a of the
/// free end small. Each bond's tension is taken from the mode's own inertia: along the fiber, where the
/// spheres are pulled in twice a period, and across it, where the slope turns the shear force into the bond;
/// both go with a^2. The moment xi_r |F_n| R/2 works against the mode's relative spin, which goes with a; the
/// energy with a^2. So the damping goes with a: about 0.204 xi_r (a/L) / r_f for long fibers, beside the
/// dashpots' xi_b / r_f^2.
double small_friction_damping(const dem::Fiber& fiber, const reference::ChainMode& mode);

}  // namespace fiberchain::compare
