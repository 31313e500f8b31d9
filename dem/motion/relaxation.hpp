#pragma once

#include <cmath>

#include "dem/model/fiber.hpp"
#include "dem/model/fluid.hpp"
#include "dem/motion/implicit_bond.hpp"
#include "dem/motion/moving_sphere.hpp"

// Stokes' drag within a step: solved, not lagged.
namespace fiberchain::dem {

/// A step of m dv/dt = F + c (u - v) with constant F and u, exactly: v -> keep v + follow u + gain F. Without
/// drag v -> v + dt/m F. The leapfrog with it is symmetric in time, hence of second order while c dt / m is
/// below about 1; a longer step has forgotten its velocity and is Euler's, x -> x + dt (u + F / c), of first
/// order.
struct Relaxation {
  double keep;    ///< exp(-c dt / m)
  double follow;  ///< 1 - keep
  double gain;    ///< (1 - keep) / c
};

/// `drag` c and `mass` m, or those of the spin; `time` may be part of a step.
inline Relaxation relaxation(double drag, double mass, double time) {
  if (drag == 0) return {1, 0, time / mass};
  const double exponent = drag * time / mass, follow = -std::expm1(-exponent);
  return {std::exp(-exponent), follow, follow / drag};
}

/// A step of a sphere with `share` of the mass and inertia of the fiber's spheres, and with drag (zero
/// without fluid).
inline SphereStep<double> sphere_step(const Fiber& fiber, double share, const StokesDrag& drag, double dt) {
  const Relaxation move = relaxation(drag.translation, share * sphere_mass(fiber), dt);
  const Relaxation turn = relaxation(drag.rotation, share * sphere_inertia(fiber), dt);
  return {move.gain, turn.gain, move.keep, move.follow, turn.keep, turn.follow};
}

/// What of the parameters depends on the step.
template <int Dim>
void set_step(MarchParameters<double, Dim>& p, const Fiber& fiber, const StokesDrag& drag, double dt) {
  p.step = dt;
  p.end_share = end_mass_share(fiber);
  p.inner = sphere_step(fiber, 1, drag, dt);
  p.end = sphere_step(fiber, p.end_share, drag, dt);
}

/// Everything that marches a fiber's spheres by steps of `dt`: no drag to settle, no loads.
template <int Dim>
MarchParameters<double, Dim> march_parameters(const Fiber& fiber, const StokesDrag& drag, double dt) {
  MarchParameters<double, Dim> p{};
  p.bond = bond_parameters(fiber);
  p.inverse_length = 1 / bond_length(fiber);
  p.rolling_arm = fiber.rolling_friction * sphere_radius(fiber) / 2;
  const BondStiffness K = unrelaxed_stiffness(fiber);
  p.solved_stretch = stiff_beta * K.stretch, p.solved_shear = stiff_beta * K.shear;
  p.solved_twist = stiff_beta * K.twist, p.solved_bend = stiff_beta * K.bend;
  set_step(p, fiber, drag, dt);
  return p;
}

}  // namespace fiberchain::dem
