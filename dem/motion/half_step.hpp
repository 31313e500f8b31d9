#pragma once

#include "dem/model/velocity_gradient.hpp"
#include "dem/motion/relaxation.hpp"

// Between the velocities of the leapfrog, half a step before the poses, and those of the poses' moment.
namespace fiberchain::dem {

/// Velocity half a step on, or the one it came from. What a stiff drag has forgotten of that is taken as the
/// fluid's: it has no part in what follows.
template <int N>
void relax(Vec<double, N>& v, const Relaxation& half, const Vec<double, N>& fluid,
           const Vec<double, N>& force, bool back) {
  const Vec<double, N> pull = half.follow * fluid + half.gain * force;
  if (!back) {
    v = half.keep * v + pull;
  } else {
    v = half.keep > 1e-100 ? (1 / half.keep) * (v - pull) : fluid;
  }
}

/// Half a step of a sphere's velocity and of its spin.
struct HalfStep {
  Relaxation move, turn;
};

/// Of a sphere with `share` of the mass and inertia of the fiber's spheres, in steps of `dt`.
inline HalfStep half_step(const Fiber& fiber, double share, const StokesDrag& drag, double dt) {
  return {relaxation(drag.translation, share * sphere_mass(fiber), dt / 2),
          relaxation(drag.rotation, share * sphere_inertia(fiber), dt / 2)};
}

template <int Dim>
void move_half_step(MovingSphere<double, Dim>& s, const HalfStep& half, const EndLoad<double, Dim>& load,
                    const Gradient& A, bool back) {
  relax(s.velocity, half.move, velocity_at<Dim>(A, s.pose.position), s.force + load.force, back);
  relax(s.spin, half.turn, spin_of<Dim>(A), s.moment + load.moment, back);
}

/// Velocity and spin of sphere number `i` half a step of `dt` on, or back, under its forces, a load and the
/// flow of gradient A.
template <int Dim>
void move_half_step(MovingSphere<double, Dim>& s, int i, const EndLoad<double, Dim>& load, const Fiber& fiber,
                    const StokesDrag& drag, const Gradient& A, double dt, bool back) {
  move_half_step(s, half_step(fiber, mass_share(fiber, i), drag, dt), load, A, back);
}

}  // namespace fiberchain::dem
