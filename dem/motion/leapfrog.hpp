#pragma once

#include "dem/motion/state.hpp"

// Leapfrog: velocities at half steps, poses and forces at full steps, dashpots at the lagged velocity (the paper's
// way). One sweep along the chain moves each sphere and evaluates the bond behind it.
namespace fiberchain::dem {

template <Physics P, class Real>
struct ChainBlock {
  static constexpr int Dim = P.dimension;
  int bonds;
  Clamps clamps;
  MovingSphere<Real, Dim>* spheres;          ///< bonds + 1
  BondHistory<Real, Dim>* history;           ///< bonds, incremental form only
  const NaturalEnds<Real, Dim>* natural;     ///< bonds, curved chains only
  const MarchParameters<Real, Dim>* parameters;
};

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

/// v(1 + dt c/2) = v(1 - dt c/2) + dt a: drag centered in the step, stable whatever c.
template <Physics P, class Real, int Dim>
void kick_and_drift(MovingSphere<Real, Dim>& sphere, const MarchParameters<Real, Dim>& p) {
  const Real& dt = p.step;
  Vec<Real, Dim> change = (dt * p.inverse_mass) * sphere.force;
  Spin<Real, Dim> spin_change = (dt * p.inverse_inertia) * sphere.moment;
  if constexpr (P.drag) {
    const Real half = Real(0.5) * dt * p.drag;
    const Real scale = Real(1.0) / (Real(1.0) + half);
    const Real keep = (Real(1.0) - half) * scale;
    sphere.velocity = keep * sphere.velocity + scale * change;
    sphere.spin = keep * sphere.spin + scale * spin_change;
  } else {
    sphere.velocity = sphere.velocity + change;
    sphere.spin = sphere.spin + spin_change;
  }
  sphere.pose.position = sphere.pose.position + dt * sphere.velocity;
  turn(sphere.pose, dt * sphere.spin);
}

template <class Real, int Dim>
void clear_forces(MovingSphere<Real, Dim>& sphere) {
  sphere.force = Vec<Real, Dim>{};
  sphere.moment = Spin<Real, Dim>{};
  for (Real& c : sphere.force.c) c = Real(0.0);
  for (Real& c : sphere.moment.c) c = Real(0.0);
}

template <Physics P, class Real>
BondLoads<Real, P.dimension> spring_loads(const ChainBlock<P, Real>& chain, int bond) {
  constexpr int Dim = P.dimension;
  Pose<Real, Dim> first = chain.spheres[bond].pose, second = chain.spheres[bond + 1].pose;
  if constexpr (P.curved) {
    first.orientation = turned(first.orientation, chain.natural[bond].first);
    second.orientation = turned(second.orientation, chain.natural[bond].second);
  }
  const BondKinematics<Real, Dim> k = bond_kinematics(first, second);
  return bond_loads(k, bond_stress<Real, Dim>(chain.parameters->bond, k.separation, k.rotation));
}

/// Forces of one bond at the poses now; `dt` is the step that led here (0 before the first).
template <Physics P, class Real>
BondLoads<Real, P.dimension> bond_step(const ChainBlock<P, Real>& chain, int bond, const Real& dt) {
  constexpr int Dim = P.dimension;
  const MovingSphere<Real, Dim>&a = chain.spheres[bond], &b = chain.spheres[bond + 1];
  const BondParameters<Real>& law = chain.parameters->bond;
  if constexpr (P.form == BondForm::total && !P.damped) {
    return spring_loads<P, Real>(chain, bond);
  } else {
    const RelativeMotion<Real, Dim> motion{b.velocity - a.velocity, Real(0.5) * (a.spin + b.spin), b.spin - a.spin};
    const Vec<Real, Dim> separation = b.pose.position - a.pose.position;
    const Vec<Real, Dim> e = unit(separation);
    if constexpr (P.form == BondForm::total) {
      return spring_loads<P, Real>(chain, bond) +
             act_at_middle(separation, dashpot_action(law, separation, e, motion));
    } else {
      advance(chain.history[bond], separation, e, motion, dt);
      BondAction<Real, Dim> action = spring_action(law, chain.history[bond], e);
      if constexpr (P.damped) action = action + dashpot_action(law, separation, e, motion);
      return act_at_middle(separation, action);
    }
  }
}

template <Physics P, class Real>
void add_bond(const ChainBlock<P, Real>& chain, int bond, const Real& dt) {
  const BondLoads<Real, P.dimension> loads = bond_step<P, Real>(chain, bond, dt);
  auto &first = chain.spheres[bond], &second = chain.spheres[bond + 1];
  first.force = first.force + loads.force_on_first;
  first.moment = first.moment + loads.moment_on_first;
  second.force = second.force - loads.force_on_first;
  second.moment = second.moment + loads.moment_on_second;
}

/// Forces at the start of a march.
template <Physics P, class Real>
void start_march(const ChainBlock<P, Real>& chain) {
  for (int i = 0; i <= chain.bonds; ++i) clear_forces(chain.spheres[i]);
  for (int i = 0; i < chain.bonds; ++i) add_bond<P, Real>(chain, i, Real(0.0));
}

/// One step; `steps_before` counts from the start of the load ramp.
template <Physics P, class Real>
void march_step(const ChainBlock<P, Real>& chain, double steps_before) {
  constexpr int Dim = P.dimension;
  const MarchParameters<Real, Dim>& p = *chain.parameters;
  const Real factor = ramp_factor(p.ramp.rate, steps_before);
  const auto load = [&](MovingSphere<Real, Dim>& sphere, const EndLoad<Real, Dim>& end) {
    sphere.force = sphere.force + end.force;
    sphere.moment = sphere.moment + end.moment;
  };
  load(chain.spheres[0], blend(p.ramp.first_from, p.ramp.first_to, factor));
  load(chain.spheres[chain.bonds], blend(p.ramp.last_from, p.ramp.last_to, factor));
  for (int i = 0; i <= chain.bonds; ++i) {
    const bool fixed = (i == 0 && chain.clamps.first) || (i == chain.bonds && chain.clamps.last);
    if (!fixed) kick_and_drift<P>(chain.spheres[i], p);
    clear_forces(chain.spheres[i]);
    if (i > 0) add_bond<P, Real>(chain, i - 1, p.step);
  }
}

}  // namespace fiberchain::dem
