#pragma once

#include "dem/motion/rolling_slot.hpp"
#include "dem/motion/moving_sphere.hpp"

// What one bond does in one step, for every integrator that marches.
namespace fiberchain::dem {

/// A chain, or as many side by side as a Real has lanes.
template <Physics P, class Real>
struct ChainBlock {
  static constexpr int Dim = P.dimension;
  using Number = Real;
  int bonds;
  Clamps clamps;
  MovingSphere<Real, Dim>* spheres;          ///< bonds + 1
  BondHistory<Real, Dim>* history;           ///< bonds, incremental form only
  const NaturalEnds<Real, Dim>* natural;     ///< bonds, curved chains only
  MarchParameters<Real, Dim> parameters;     ///< a copy: what is written cannot be one of them
  Real* workspace = nullptr;                 ///< what solving along the chain needs
  const EndLoad<Real, Dim>* dead = nullptr;  ///< bonds + 1, fluid only: dead loads, null if there are none

  bool fixed(int sphere) const { return (sphere == 0 && clamps.first) || (sphere == bonds && clamps.last); }
};

template <Physics P, class Real>
BondLoads<Real, P.dimension> spring_loads(const ChainBlock<P, Real>& chain, int bond,
                                          Pose<Real, P.dimension> first, Pose<Real, P.dimension> second) {
  if constexpr (P.curved) {
    first.orientation = turned(first.orientation, chain.natural[bond].first);
    second.orientation = turned(second.orientation, chain.natural[bond].second);
  }
  const BondKinematics<Real, P.dimension> k = bond_kinematics(first, second);
  return bond_loads(k, bond_stress<Real, P.dimension>(chain.parameters.bond, k.separation, k.rotation));
}

/// Rolling friction of the bond: its moment, or how large it may get.
template <Physics P, class Real>
void add_rolling(const ChainBlock<P, Real>& chain, int bond, const BondHistory<Real, P.dimension>& history,
                 const BondVector<Real, P.dimension>& line, const RelativeMotion<Real, P.dimension>& motion,
                 BondAction<Real, P.dimension>& action) {
  using std::abs;
  const MarchParameters<Real, P.dimension>& p = chain.parameters;
  const Real largest = p.rolling_arm * abs(spring_tension(p.bond, history, line));
  if constexpr (P.rolling == Rolling::explicit_sign) {
    action.moment = action.moment + sliding_moment(largest, motion.relative_spin);
  } else {
    rolling_slots(chain)[bond].limit = p.angular_impulse * largest;
  }
}

/// Forces of one bond at the poses now; `dt` is the step that previous_step here (0 before the first).
template <Physics P, class Real>
BondLoads<Real, P.dimension> bond_step(const ChainBlock<P, Real>& chain, int bond,
                                       const MovingSphere<Real, P.dimension>& a,
                                       const MovingSphere<Real, P.dimension>& b, const Real& dt) {
  constexpr int Dim = P.dimension;
  if constexpr (P.form == BondForm::total && !P.damped) {
    return spring_loads<P, Real>(chain, bond, a.pose, b.pose);
  } else {
    const BondParameters<Real>& law = chain.parameters.bond;
    const RelativeMotion<Real, Dim> motion{b.velocity - a.velocity, Real(0.5) * (a.spin + b.spin), b.spin - a.spin};
    const BondVector<Real, Dim> line =
        bond_vector<Real, Dim>(b.pose.position - a.pose.position, chain.parameters.inverse_length);
    if constexpr (P.form == BondForm::total) {
      return spring_loads<P, Real>(chain, bond, a.pose, b.pose) +
             act_at_middle(line.vector, dashpot_action(law, line.vector, line.inverse_length * line.vector, motion));
    } else {
      BondHistory<Real, Dim> history = chain.history[bond];
      advance(history, line, motion, dt);
      chain.history[bond] = history;
      BondAction<Real, Dim> action = incremental_action<P.damped>(law, history, line, motion);
      if constexpr (P.rolling != Rolling::none) add_rolling<P, Real>(chain, bond, history, line, motion, action);
      return act_at_middle(line.vector, action);
    }
  }
}

}  // namespace fiberchain::dem
