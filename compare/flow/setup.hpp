#pragma once

#include "dem/flow/integrate_in_flow.hpp"
#include "dem/scene/build_fiber.hpp"

// Fibers in a flow by their dimensionless numbers. L = 2RN here: the spheres' whole length, which is what the
// fluid acts on.
namespace fiberchain::compare {

/// The nominal fiber of that many spheres, r_f = N - 1. Throws dem::InvalidInput unless spheres >= 2.
dem::Fiber fiber_of_spheres(int spheres, double poisson_ratio = 0.3);

/// 3 pi mu rate L^4/(E I)
double elasto_viscous_number(const dem::Fiber& fiber, double viscosity, double rate);

/// The viscosity [Pa s] that gives that number.
double viscosity_of(const dem::Fiber& fiber, double elasto_viscous, double rate);

}  // namespace fiberchain::compare
