#pragma once

#include <string_view>

namespace fiberchain::dem {

/// How a chain's motion is followed in time.
enum class Integrator {
  leapfrog,         ///< explicit, dashpots at the velocity half a step before (the paper's way)
  leapfrog_damped,  ///< explicit springs, dashpots solved within the step: stable up to the undamped limit
  leapfrog_stiff,   ///< springs and dashpots solved within the step: beyond the bonds' own step
  implicit,         ///< midpoint, energy-consistent: any step; energy changes by work and damping only
  cvode,            ///< SUNDIALS' variable-order BDF with the chain's own block-tridiagonal Newton solver
  automatic         ///< the cheapest of these that keeps the requested error
};

constexpr std::string_view name(Integrator integrator) {
  switch (integrator) {
    case Integrator::leapfrog:
      return "leapfrog";
    case Integrator::leapfrog_damped:
      return "leapfrog-damped";
    case Integrator::leapfrog_stiff:
      return "leapfrog-stiff";
    case Integrator::implicit:
      return "implicit";
    case Integrator::cvode:
      return "cvode";
    default:
      return "auto";
  }
}

/// Whether it is one of the leapfrogs, which march in lanes.
constexpr bool is_leapfrog(Integrator integrator) {
  return integrator == Integrator::leapfrog || integrator == Integrator::leapfrog_damped ||
         integrator == Integrator::leapfrog_stiff;
}

/// What a run took, whatever the machine.
struct Work {
  double steps = 0;             ///< time steps, rejected ones included
  double bond_evaluations = 0;  ///< forces of one bond
  double linear_solves = 0;     ///< eliminations along a whole chain
  double factorizations = 0;    ///< Newton matrices set up
};

}  // namespace fiberchain::dem
