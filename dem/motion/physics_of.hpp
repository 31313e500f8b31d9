#pragma once

#include <span>

#include "dem/chain/chain.hpp"
#include "dem/motion/integrator.hpp"
#include "dem/motion/physics.hpp"

namespace fiberchain::dem {

/// What a leapfrog solves for within the step.
constexpr Solved solved_by(Integrator integrator) {
  switch (integrator) {
    case Integrator::leapfrog_damped:
      return Solved::dashpots;
    case Integrator::leapfrog_stiff:
      return Solved::bonds;
    default:
      return Solved::nothing;
  }
}

/// Physics of a march that its fibers do not tell.
struct MarchOptions {
  BondForm form = BondForm::total;
  bool settling_damping = false;    ///< drag that settles the chain
  Solved solved = Solved::nothing;  ///< within the step: dashpots where there are any, springs always
  Rolling rolling = Rolling::none;  ///< scheme of the rolling friction, for fibers that have any
  bool fluid = false;               ///< a flow drags the spheres
};

/// The one physics of fibers that march together: what none of them has is not in it.
template <int Dim>
Physics physics_of(std::span<const Chain<Dim>> chains, const MarchOptions& options);

template <int Dim>
Physics physics_of(const Chain<Dim>& chain, const MarchOptions& options) {
  return physics_of<Dim>(std::span<const Chain<Dim>>(&chain, 1), options);
}

}  // namespace fiberchain::dem
