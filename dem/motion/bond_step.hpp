#pragma once

#include "dem/motion/moving_sphere.hpp"
#include "dem/motion/rolling_slot.hpp"
#include "dem/simd/as_numbers.hpp"

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
  BondBranches<Real> branches = {};          ///< of bonds that have any
  Real* memory = nullptr;  ///< bonds with branches: of each its history, then the strains of its branches
  std::size_t bond_memory = 0;  ///< numbers of one of them

  bool is_end(int sphere) const { return sphere == 0 || sphere == bonds; }
  const SphereStep<Real>& step_of(int sphere) const {
    return is_end(sphere) ? parameters.end : parameters.inner;
  }
  bool fixed(int sphere) const { return (sphere == 0 && clamps.first) || (sphere == bonds && clamps.last); }
};

template <Physics P, class Real>
using HistoryOf = BondLawHistory<BondLaw<P>, Real, P.dimension>;

template <Physics P>
inline constexpr bool needs_motion = P.damped || has_history<BondLaw<P>>;

/// Pose of a bond's end: its sphere's, turned to where the bond is straight. `natural` gives the turn.
template <Physics P, class Real, class Natural>
decltype(auto) end_pose(const Pose<Real, P.dimension>& sphere, const Natural& natural) {
  if constexpr (P.curved) {
    return Pose<Real, P.dimension>{sphere.position, turned(sphere.orientation, natural())};
  } else {
    return (sphere);
  }
}

template <Physics P, class Real>
BondVector<Real, P.dimension> bond_line(const ChainBlock<P, Real>& chain,
                                        const MovingSphere<Real, P.dimension>& a,
                                        const MovingSphere<Real, P.dimension>& b) {
  if constexpr (needs_motion<P>) {
    return bond_vector<Real, P.dimension>(b.pose.position - a.pose.position, chain.parameters.inverse_length);
  } else {
    return {};
  }
}

template <Physics P, class Real>
RelativeMotion<Real, P.dimension> relative_motion(const MovingSphere<Real, P.dimension>& a,
                                                  const MovingSphere<Real, P.dimension>& b) {
  if constexpr (needs_motion<P>) {
    return {b.velocity - a.velocity, Real(0.5) * (a.spin + b.spin), b.spin - a.spin};
  } else {
    return {};
  }
}

/// Calls use(now) with bond `bond` between spheres a and b as its law sees it. Line and motion where it or
/// the dashpots need them. All are made, none assigned: GCC 12 assigns packs 16 bytes at a time, and reading
/// them whole waits for that.
template <Physics P, class Real, class Use>
auto with_configuration(const ChainBlock<P, Real>& chain, int bond, const MovingSphere<Real, P.dimension>& a,
                        const MovingSphere<Real, P.dimension>& b, const Use& use) {
  const auto& first = end_pose<P, Real>(a.pose, [&] { return chain.natural[bond].first; });
  const auto& second = end_pose<P, Real>(b.pose, [&] { return chain.natural[bond].second; });
  const BondVector<Real, P.dimension> line = bond_line<P, Real>(chain, a, b);
  const RelativeMotion<Real, P.dimension> motion = relative_motion<P, Real>(a, b);
  return use(BondConfiguration<Real, P.dimension>{first, second, line, motion});
}

/// The history before the step.
template <Physics P, class Real>
HistoryOf<P, Real> history_before(const ChainBlock<P, Real>& chain, int bond) {
  if constexpr (has_history<BondLaw<P>>) {
    return chain.history[bond];
  } else {
    return {};
  }
}

/// Calls use(history, strains) with those of bond `bond` and of its Maxwell branches.
template <Physics P, class Real, class Use>
auto with_memory(const ChainBlock<P, Real>& chain, int bond, const Use& use) {
  Real* memory = chain.memory + bond * chain.bond_memory;
  using History = HistoryOf<P, Real>;
  if constexpr (has_history<BondLaw<P>>) {
    return use(*as_values<History>(memory), memory + numbers_of<History, Real>);
  } else {
    History none;
    return use(none, memory);
  }
}

/// Moves it on over a step of `dt` that led here.
template <Physics P, class Real>
void advance_history(const ChainBlock<P, Real>& chain, HistoryOf<P, Real>& history,
                     const BondConfiguration<Real, P.dimension>& now, const Real& dt) {
  if constexpr (has_history<BondLaw<P>>) BondLaw<P>::advance(chain.parameters.bond, history, now, dt);
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
    rolling_slots(chain)[bond].limit = chain.parameters.inner.angular_impulse * largest;
  }
}

/// Forces of one bond as it is now; the history has moved on to here.
template <Physics P, class Real>
BondLoads<Real, P.dimension> bond_loads_now(const ChainBlock<P, Real>& chain, int bond,
                                            const HistoryOf<P, Real>& history,
                                            const BondConfiguration<Real, P.dimension>& now) {
  using Law = BondLaw<P>;
  const BondParameters<Real>& law = chain.parameters.bond;
  if constexpr (Law::from_poses) {
    if constexpr (P.damped) {
      return Law::loads(law, history, now) + dashpot_loads(law, now);
    } else {
      return Law::loads(law, history, now);
    }
  } else {
    BondAction<Real, P.dimension> action = Law::template action<P.damped>(law, history, now);
    if constexpr (P.rolling != Rolling::none) add_rolling<P, Real>(chain, bond, history, now, action);
    return act_at_middle(now.line.vector, action);
  }
}

/// Forces of one bond at the poses now; `dt` is the step that led here (0 before the first). The history
/// moves on.
template <Physics P, class Real>
BondLoads<Real, P.dimension> bond_step(const ChainBlock<P, Real>& chain, int bond,
                                       const MovingSphere<Real, P.dimension>& a,
                                       const MovingSphere<Real, P.dimension>& b, const Real& dt) {
  const auto use = [&](const BondConfiguration<Real, P.dimension>& now) {
    if constexpr (P.branches) {
      return with_memory(chain, bond, [&](HistoryOf<P, Real>& history, Real* strains) {
        return BondLaw<P>::template loads<P.damped>(chain.parameters.bond, chain.branches, history, strains,
                                                    now, dt);
      });
    } else if constexpr (P.fails) {
      return BondLaw<P>::loads(chain.parameters.bond, chain.history[bond], now, dt);
    } else {
      HistoryOf<P, Real> history = history_before<P, Real>(chain, bond);
      advance_history<P, Real>(chain, history, now, dt);
      if constexpr (has_history<BondLaw<P>>) chain.history[bond] = history;
      return bond_loads_now<P, Real>(chain, bond, history, now);
    }
  };
  return with_configuration<P, Real>(chain, bond, a, b, use);
}

}  // namespace fiberchain::dem
