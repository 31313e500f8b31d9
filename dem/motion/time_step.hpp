#pragma once

#include "dem/model/fiber.hpp"
#include "dem/model/fluid.hpp"

namespace fiberchain::dem {

/// Largest stable step [s] of the leapfrog with lagged damping on an endless straight chain, whose spectrum
/// bounds that of every finite one. A wave with stiffness, dashpot and mass matrices K, C, M is stable while
/// 4 M - 2 dt C - dt^2 K is positive definite: the amplification leaves the unit circle at -1. `drag` [1/s]
/// adds to C. Holds for the bond model and damping of the fiber at hand. Of a fiber with lighter ends
/// (the cylinder's mass, spheres that do not touch) no more than that of the finite chain: ends of half the
/// mass lower it to 0.916 of the corrected bond's. Throws InvalidInput as check() does.
double stable_time_step(const Fiber& fiber, double drag = 0.0);

/// The same of the leapfrog with the dashpots solved within the step: that of the undamped chain, whatever
/// the dashpots.
double undamped_time_step(const Fiber& fiber);

/// The same in a fluid, whose drag c is solved within the step: while 2 c coth(c dt / (2 m)) - 2 C - dt K is
/// positive definite, c and m those of displacement and spin. Drag makes the stable step longer: without
/// dashpots it grows from 2 / w to 2 c / K.
double stable_time_step(const Fiber& fiber, const Fluid& fluid);

}  // namespace fiberchain::dem
