#pragma once

#include "dem/bond/dashpot_matrix.hpp"
#include "dem/motion/moving_sphere.hpp"
#include "dem/motion/physics.hpp"

// A bond's part in the matrix of a step that is solved along the chain (implicit_kick.hpp): dt/2 C, and with
// the springs also beta dt^2 K, K the stiffness of the straight bond in the bond's frame now. Springs have
// the same matrix as dashpots, on velocities in place of displacements.
namespace fiberchain::dem {

/// beta of the springs that are solved for. At 1/4 nothing but the inertia holds against tension, which is
/// explicit (stiff_limits.hpp); the error of a mode's damping ratio is (beta/2 + 1/24) (w dt)^2.
inline constexpr double stiff_beta = 0.3;

/// dt/2 C + beta dt^2 K (without springs dt/2 C) as dashpots [kg], [kg m^2].
template <Physics P, class Real>
BondParameters<Real> solved_dashpots(const MarchParameters<Real, P.dimension>& p) {
  BondParameters<Real> law = p.bond;
  const Real half = Real(0.5) * p.step;
  for (Real* c : {&law.dash_stretch, &law.dash_shear, &law.dash_twist, &law.dash_bend}) *c = half * *c;
  if constexpr (P.solved == Solved::bonds) {
    const Real squared = p.step * p.step;
    law.dash_stretch = law.dash_stretch + squared * p.solved_stretch;
    law.dash_shear = law.dash_shear + squared * p.solved_shear;
    law.dash_twist = law.dash_twist + squared * p.solved_twist;
    law.dash_bend = law.dash_bend + squared * p.solved_bend;
  }
  return law;
}

/// beta dt^2 K alone as dashpots [kg], [kg m^2].
template <class Real, int Dim>
BondParameters<Real> solved_springs(const MarchParameters<Real, Dim>& p) {
  BondParameters<Real> law = p.bond;
  const Real squared = p.step * p.step;
  law.dash_stretch = squared * p.solved_stretch;
  law.dash_shear = squared * p.solved_shear;
  law.dash_twist = squared * p.solved_twist;
  law.dash_bend = squared * p.solved_bend;
  return law;
}

}  // namespace fiberchain::dem
