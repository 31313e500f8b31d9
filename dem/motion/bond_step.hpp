#pragma once

#include "dem/motion/moving_sphere.hpp"
#include "dem/motion/rolling_slot.hpp"

// One bond in one step, for the three engines of the leapfrog: its law, its dashpots, its rolling friction.
namespace fiberchain::dem {

/// A chain, or as many side by side as a Real has lanes.
template <Physics P, class Real>
struct ChainBlock {
  static constexpr int Dim = P.dimension;
  using Number = Real;
  int bonds;
  Clamps clamps;
  MovingSphere<Real, Dim>* spheres;                ///< bonds + 1
  BondLawHistory<BondLaw<P>, Real, Dim>* history;  ///< bonds, of laws that have one
  const NaturalEnds<Real, Dim>* natural;           ///< bonds, curved chains only
  MarchParameters<Real, Dim> parameters;     ///< a copy, which no store to a sphere or a history can alias
  Real* workspace = nullptr;                 ///< slots of the solve along the chain
  const EndLoad<Real, Dim>* dead = nullptr;  ///< bonds + 1, fluid only: dead loads, null if there are none

  bool fixed(int sphere) const { return (sphere == 0 && clamps.first) || (sphere == bonds && clamps.last); }
};

template <Physics P, class Real>
using HistoryOf = BondLawHistory<BondLaw<P>, Real, P.dimension>;

/// Bond `bond` between spheres a and b as its law sees it. Poses where the law needs them, line and motion
/// where it or the dashpots do.
template <Physics P, class Real>
BondConfiguration<Real, P.dimension> configuration(const ChainBlock<P, Real>& chain, int bond,
                                                   const MovingSphere<Real, P.dimension>& a,
                                                   const MovingSphere<Real, P.dimension>& b) {
  constexpr int Dim = P.dimension;
  BondConfiguration<Real, Dim> now{.first = a.pose, .second = b.pose, .line = {}, .motion = {}};
  if constexpr (P.curved) {
    now.first.orientation = turned(now.first.orientation, chain.natural[bond].first);
    now.second.orientation = turned(now.second.orientation, chain.natural[bond].second);
  }
  if constexpr (P.damped || has_history<BondLaw<P>>) {
    now.line = bond_vector<Real, Dim>(b.pose.position - a.pose.position, chain.parameters.inverse_length);
    now.motion = {b.velocity - a.velocity, Real(0.5) * (a.spin + b.spin), b.spin - a.spin};
  }
  return now;
}

/// The history at the end of a step of `dt` that led here.
template <Physics P, class Real>
HistoryOf<P, Real> advanced_history(const ChainBlock<P, Real>& chain, int bond,
                                    const BondConfiguration<Real, P.dimension>& now, const Real& dt) {
  HistoryOf<P, Real> history{};
  if constexpr (has_history<BondLaw<P>>) {
    history = chain.history[bond];
    BondLaw<P>::advance(chain.parameters.bond, history, now, dt);
  }
  return history;
}

/// Largest moment of the rolling friction, xi_r |N| R / 2 (Eq 21) [N m].
template <Physics P, class Real>
Real largest_rolling_moment(const ChainBlock<P, Real>& chain, const HistoryOf<P, Real>& history,
                            const BondConfiguration<Real, P.dimension>& now) {
  using std::abs;
  const MarchParameters<Real, P.dimension>& p = chain.parameters;
  return p.rolling_arm * abs(BondLaw<P>::tension(p.bond, history, now));
}

/// Rolling friction of the bond: its moment, or how large it may get.
template <Physics P, class Real>
void add_rolling(const ChainBlock<P, Real>& chain, int bond, const HistoryOf<P, Real>& history,
                 const BondConfiguration<Real, P.dimension>& now, BondAction<Real, P.dimension>& action) {
  const Real largest = largest_rolling_moment<P, Real>(chain, history, now);
  if constexpr (P.rolling == Rolling::explicit_sign) {
    action.moment = action.moment + sliding_moment(largest, now.motion.relative_spin);
  } else {
    rolling_slots(chain)[bond].limit = chain.parameters.angular_impulse * largest;
  }
}

/// Forces of one bond at the poses now; `dt` is the step that led here (0 before the first). The history
/// moves on.
template <Physics P, class Real>
BondLoads<Real, P.dimension> bond_step(const ChainBlock<P, Real>& chain, int bond,
                                       const MovingSphere<Real, P.dimension>& a,
                                       const MovingSphere<Real, P.dimension>& b, const Real& dt) {
  constexpr int Dim = P.dimension;
  using Law = BondLaw<P>;
  const BondParameters<Real>& law = chain.parameters.bond;
  const BondConfiguration<Real, Dim> now = configuration<P, Real>(chain, bond, a, b);
  const HistoryOf<P, Real> history = advanced_history<P, Real>(chain, bond, now, dt);
  if constexpr (has_history<Law>) chain.history[bond] = history;
  if constexpr (Law::from_poses) {
    const BondLoads<Real, Dim> springs = Law::loads(law, history, now);
    if constexpr (P.damped) {
      return springs + dashpot_loads(law, now);
    } else {
      return springs;
    }
  } else {
    BondAction<Real, Dim> action = Law::template action<P.damped>(law, history, now);
    if constexpr (P.rolling != Rolling::none) add_rolling<P, Real>(chain, bond, history, now, action);
    return act_at_middle(now.line.vector, action);
  }
}

}  // namespace fiberchain::dem
