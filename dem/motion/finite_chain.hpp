#pragma once

#include "dem/model/fiber.hpp"

namespace fiberchain::dem {

/// Whether the leapfrog with lagged damping is stable on a straight chain as long as this one, free at both
/// ends, at a step `dt` [s]: 4 M - 2 dt C - dt^2 K positive definite, by elimination along the chain. End
/// spheres with less than half of the others' mass, or with half of it where rotation bounds the step, move
/// faster than any wave of the endless chain. `drag` [1/s] adds to C.
bool finite_chain_is_stable(const Fiber& fiber, double dt, double drag);

}  // namespace fiberchain::dem
