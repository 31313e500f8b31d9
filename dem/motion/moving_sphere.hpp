#pragma once

#include "dem/bond/incremental.hpp"
#include "dem/bond/pose.hpp"
#include "dem/motion/physics.hpp"

// The state of a marching chain and what marches it. Every type consists of `Real`s only, so that a block of
// lanes is an array of doubles in which lane k of number n stands at n * width + k.
namespace fiberchain::dem {

/// One sphere: pose at the step, velocities half a step before, forces at the step.
template <class Real, int Dim>
struct MovingSphere {
  Pose<Real, Dim> pose;
  Vec<Real, Dim> velocity;  ///< [m/s]
  Spin<Real, Dim> spin;     ///< [1/s]
  Vec<Real, Dim> force;     ///< of the bonds [N]
  Spin<Real, Dim> moment;   ///< of the bonds [N m]
};

/// A sphere with velocity and spin of another.
template <class Real, int Dim>
MovingSphere<Real, Dim> with_velocities(MovingSphere<Real, Dim> sphere,
                                        const MovingSphere<Real, Dim>& other) {
  sphere.velocity = other.velocity;
  sphere.spin = other.spin;
  return sphere;
}

template <class Real, int Dim>
struct EndLoad {
  Vec<Real, Dim> force;
  Spin<Real, Dim> moment;
};

/// Dead loads on the two end spheres, going from one set to another: (1 - f) from + f to, where f rises
/// smoothly from 0 to 1 over 1 / rate steps and stays there.
template <class Real, int Dim>
struct LoadRamp {
  EndLoad<Real, Dim> first_from, first_to, last_from, last_to;
  Real rate;  ///< 1 / number of steps
};

/// What a step does to a sphere.
template <class Real>
struct SphereStep {
  Real impulse;  ///< velocity per force over a step: dt / m, in a fluid (1 - keep) / (6 pi mu R) [s/kg]
  Real angular_impulse;  ///< spin per moment over a step: dt / J, in a fluid (1 - spin_keep) / (8 pi mu R^3)
                         ///< [s/(kg m^2)]
  Real keep,
      follow;  ///< fluid: parts of the sphere's and the fluid's velocity in the next one; their sum is 1
  Real spin_keep, spin_follow;
};

template <class Real, int Dim>
struct MarchParameters {
  BondParameters<Real> bond;
  Real inverse_length;          ///< 1 / l_0 [1/m]
  SphereStep<Real> inner, end;  ///< of the spheres between the ends, and of those
  Real end_share;               ///< mass of an end sphere over that of the others
  Real step;                    ///< dt [s]
  /// beta K of the springs that are solved for within the step (implicit_bond.hpp), those of Maxwell
  /// branches with them.
  Real solved_stretch, solved_shear, solved_twist, solved_bend;
  Real drag;         ///< force per momentum [1/s]
  Real rolling_arm;  ///< xi_r R / 2 [m]
  LoadRamp<Real, Dim> ramp;
};

/// Which ends keep position and rotation.
struct Clamps {
  bool first, last;
};

}  // namespace fiberchain::dem
