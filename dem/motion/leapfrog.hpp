#pragma once

#include "dem/motion/bond_step.hpp"
#include "dem/motion/implicit_kick.hpp"
#include "dem/motion/local_flow.hpp"
#include "dem/motion/rolling.hpp"

// Leapfrog: velocities at half steps, poses and forces at full steps, dashpots at the lagged velocity (the
// paper's way) or solved for along the chain, with the springs or without (implicit_kick.hpp). One sweep
// along the chain moves each sphere and evaluates the bond behind it.
namespace fiberchain::dem {

template <class Real>
Real ramp_factor(const Real& rate, double steps) {
  using std::min;
  const Real s = min(Real(1.0), rate * Real(steps));
  return s * s * (Real(3.0) - Real(2.0) * s);
}

template <class Real, int Dim>
EndLoad<Real, Dim> blend(const EndLoad<Real, Dim>& from, const EndLoad<Real, Dim>& to, const Real& factor) {
  const Real rest = Real(1.0) - factor;
  return {rest * from.force + factor * to.force, rest * from.moment + factor * to.moment};
}

template <class Real>
void turn(Pose<Real, 2>& pose, const Vec<Real, 1>& angle) {
  pose.orientation = pose.orientation + angle[0];
}

template <class Real>
void turn(Pose<Real, 3>& pose, const Vec<Real, 3>& angle) {
  pose.orientation = cayley_turn(Real(0.5) * angle, pose.orientation);
}

template <class Real, int Dim>
void add_load(MovingSphere<Real, Dim>& sphere, const EndLoad<Real, Dim>& load) {
  sphere.force = sphere.force + load.force;
  sphere.moment = sphere.moment + load.moment;
}

/// Settling drag: v(1 + dt c/2) = v(1 - dt c/2) + dt a, centered in the step, stable whatever c. Stokes'
/// drag: the velocity goes over to the fluid's at the sphere as exp(-c t), exactly.
template <Physics P, class Real, int Dim>
void kick(MovingSphere<Real, Dim>& sphere, const MarchParameters<Real, Dim>& p, const SphereStep<Real>& own,
          const LocalFlow<P, Real>& flow) {
  const Vec<Real, Dim> change = own.impulse * sphere.force;
  const Spin<Real, Dim> spin_change = own.angular_impulse * sphere.moment;
  if constexpr (P.fluid) {
    sphere.velocity =
        own.keep * sphere.velocity + own.follow * (flow.gradient * sphere.pose.position) + change;
    sphere.spin = own.spin_keep * sphere.spin + own.spin_follow * flow.spin + spin_change;
  } else if constexpr (P.settling_damping) {
    const Real half = Real(0.5) * p.step * p.drag;
    const Real scale = Real(1.0) / (Real(1.0) + half);
    const Real keep = (Real(1.0) - half) * scale;
    sphere.velocity = keep * sphere.velocity + scale * change;
    sphere.spin = keep * sphere.spin + scale * spin_change;
  } else {
    sphere.velocity = sphere.velocity + change;
    sphere.spin = sphere.spin + spin_change;
  }
}

template <class Real, int Dim>
void drift(MovingSphere<Real, Dim>& sphere, const Real& dt) {
  sphere.pose.position = sphere.pose.position + dt * sphere.velocity;
  turn(sphere.pose, dt * sphere.spin);
}

template <class Real, int Dim>
void clear_forces(MovingSphere<Real, Dim>& sphere) {
  for (Real& c : sphere.force.c) c = Real(0.0);
  for (Real& c : sphere.moment.c) c = Real(0.0);
}

/// The forces of bond `bond` at the poses now onto its two spheres; `dt` is the step that previous_step here
/// (0 at the start).
template <Physics P, class Real>
void add_bond(const ChainBlock<P, Real>& chain, int bond, MovingSphere<Real, P.dimension>& first,
              MovingSphere<Real, P.dimension>& second, const Real& dt) {
  const auto loads = bond_step<P, Real>(chain, bond, first, second, dt);
  first.force = first.force + loads.force_on_first;
  first.moment = first.moment + loads.moment_on_first;
  second.force = second.force - loads.force_on_first;
  second.moment = second.moment + loads.moment_on_second;
}

/// Forces at the start of a march.
template <Physics P, class Real>
void start_march(const ChainBlock<P, Real>& chain) {
  for (int i = 0; i <= chain.bonds; ++i) clear_forces(chain.spheres[i]);
  for (int i = 0; i < chain.bonds; ++i)
    add_bond<P, Real>(chain, i, chain.spheres[i], chain.spheres[i + 1], Real(0.0));
}

template <Physics P, class Real>
void load_ends(const ChainBlock<P, Real>& chain, double steps_before) {
  const auto& ramp = chain.parameters.ramp;
  const Real factor = ramp_factor(ramp.rate, steps_before);
  add_load(chain.spheres[0], blend(ramp.first_from, ramp.first_to, factor));
  add_load(chain.spheres[chain.bonds], blend(ramp.last_from, ramp.last_to, factor));
}

template <Physics P, class Real>
void add_dead_loads(const ChainBlock<P, Real>& chain) {
  if (chain.dead == nullptr) return;
  for (int i = 0; i <= chain.bonds; ++i) add_load(chain.spheres[i], chain.dead[i]);
}

/// The kick where the spheres' velocities depend on each other.
template <Physics P, class Real>
void kick_together(const ChainBlock<P, Real>& chain, const LocalFlow<P, Real>& flow) {
  if constexpr (P.solved != Solved::nothing) {
    implicit_kick<P, Real>(chain, flow);
  } else {
    for (int i = 0; i <= chain.bonds; ++i) {
      if (!chain.fixed(i))
        kick<P>(chain.spheres[i], chain.parameters, chain.step_of(i), LocalFlow<P, Real>{});
    }
    kick_with_rolling(chain);
  }
}

/// Velocities from those of the lagged moment to those of the poses' or, with `back`, the other way, where
/// they depend on each other. At the poses' moment the dashpots act by the velocity there: none is left to
/// solve.
template <Physics P, class Real>
void half_kick(ChainBlock<P, Real> chain, double steps_before, const LocalFlow<P, Real>& flow, bool back) {
  load_ends<P, Real>(chain, steps_before);
  if constexpr (P.fluid) add_dead_loads(chain);
  BondParameters<Real>& bond = chain.parameters.bond;
  if (back) bond.dash_stretch = bond.dash_shear = bond.dash_twist = bond.dash_bend = Real(0.0);
  implicit_kick<P, Real>(chain, flow, Real(back ? -0.5 : 0.5));
}

/// One step; `steps_before` counts from the start of the load ramp. The sphere whose second bond is still to
/// come stays in registers.
template <Physics P, class Real>
void march_step(const ChainBlock<P, Real>& chain, double steps_before, const LocalFlow<P, Real>& flow = {}) {
  load_ends<P, Real>(chain, steps_before);
  constexpr bool kick_alone = P.solved == Solved::nothing && P.rolling != Rolling::set_valued;
  if constexpr (!kick_alone) {
    if constexpr (P.fluid) add_dead_loads(chain);
    kick_together<P, Real>(chain, flow);
  }
  MovingSphere<Real, P.dimension> before;
  for (int i = 0; i <= chain.bonds; ++i) {
    MovingSphere<Real, P.dimension> sphere = chain.spheres[i];
    if (!chain.fixed(i)) {
      if constexpr (P.fluid && kick_alone) {
        if (chain.dead) add_load(sphere, chain.dead[i]);
      }
      if constexpr (kick_alone) kick<P>(sphere, chain.parameters, chain.step_of(i), flow);
      drift(sphere, chain.parameters.step);
    }
    clear_forces(sphere);
    if (i > 0) {
      add_bond<P, Real>(chain, i - 1, before, sphere, chain.parameters.step);
      chain.spheres[i - 1] = before;
    }
    before = sphere;
  }
  chain.spheres[chain.bonds] = before;
}

/// Reals that solving along the chain needs.
template <Physics P, class Real>
constexpr std::size_t workspace_reals(int bonds) {
  if (P.solved != Solved::nothing) return (bonds + 1) * numbers_of<EliminationSlot<Real, P.dimension>, Real>;
  if (P.rolling == Rolling::set_valued) return bonds * numbers_of<RollingSlot<Real, P.dimension>, Real>;
  return 0;
}

}  // namespace fiberchain::dem
