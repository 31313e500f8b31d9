#pragma once

#include "dem/motion/kernels/packing_rows.hpp"
#include "dem/simd/flatten.hpp"

// What bonds take in a step: dashpots, rolling friction, laws that dissipate, the scheme that solves for
// them.
namespace fiberchain::dem {

/// Loads of one bond that take energy, at the step before.
template <class Real>
struct PreviousLoads {
  BondLoads<Real, 3> loads;
  Real power;           ///< of the dashpots' loads [W]
  Vec<Real, 3> moment;  ///< of explicit rolling friction, on the first sphere [N m]
  Real rolling_power;   ///< [W]
  Vec<Real, 3> spin;    ///< relative, half a step before the kick [1/s]
};

/// Energy taken by the dashpots [J]. A kick with a force takes force times the mean of the velocities before
/// and after it, exactly: those of this step and of the one before, whose loads are `previous`.
template <class Real>
void account_dashpots(const PackingBlock& block, const MarchParameters<Real, 3>& p,
                      const MovingSphere<Real, 3>& a, const MovingSphere<Real, 3>& b,
                      const BondConfiguration<Real, 3>& now, PreviousLoads<Real>& previous, Real& damping) {
  const Real half = Real(0.5) * Real(block.previous_step);
  damping =
      damping + half * (previous.power + power_taken(previous.loads, now.motion.velocity, a.spin, b.spin));
  previous.loads = dashpot_loads(p.bond, now);
  previous.power = power_taken(previous.loads, now.motion.velocity, a.spin, b.spin);
  // the first kick began half a step before the start
  if (block.previous_step == 0) damping = damping - Real(0.5) * p.step * previous.power;
}

/// Relative motion of a bond's spheres before a kick, and where it was.
template <class Real>
struct PreviousMotion {
  Vec<Real, 3> separation;
  RelativeMotion<Real, 3> motion;
  Real counted;  ///< part of the kick that is accounted: a half of the first, which began before the start
  Real unused[4];
};

/// Energy taken by the dashpots of a bond that is solved for, and by the springs' part of the matrix [J]. The
/// kick takes dt C of the mean velocity and beta dt^2 K of the change, both times the mean: exactly.
template <class Real>
void account_solved(const PackingBlock& block, const MarchParameters<Real, 3>& p,
                    const BondConfiguration<Real, 3>& now, PreviousMotion<Real>& previous, Real& damping,
                    Real& scheme) {
  const RelativeMotion<Real, 3>&before = previous.motion, &after = now.motion;
  if (block.previous_step > 0) {
    const Real half(0.5);
    const RelativeMotion<Real, 3> mean{half * (before.velocity + after.velocity),
                                       half * (before.mean_spin + after.mean_spin),
                                       half * (before.relative_spin + after.relative_spin)},
        change{after.velocity - before.velocity, after.mean_spin - before.mean_spin,
               after.relative_spin - before.relative_spin};
    const Vec<Real, 3>& r = previous.separation;
    const Vec<Real, 3> e = bond_vector<Real, 3>(r, p.inverse_length).inverse_length * r;
    const auto work = [&](const BondAction<Real, 3>& action) {
      return previous.counted * (dot(action.force, mean.velocity - cross(mean.mean_spin, r)) +
                                 dot(action.moment, mean.relative_spin));
    };
    damping = damping + p.step * work(dashpot_action(p.bond, r, e, mean));
    scheme = scheme + work(dashpot_action(solved_springs<Real, 3>(p), r, e, change));
  }
  previous = {now.line.vector, now.motion, Real(block.previous_step > 0 ? 1.0 : 0.5), {}};
}

/// Energy taken by the rolling friction [J], likewise.
template <Physics P, class Real>
void account_rolling(const PackingBlock& block, const ChainBlock<P, Real>& chain, int bond,
                     const BondConfiguration<Real, 3>& now, PreviousLoads<Real>& previous, Real& friction) {
  const MarchParameters<Real, 3>& p = chain.parameters;
  const Vec<Real, 3>& spin = now.motion.relative_spin;
  if constexpr (P.rolling == Rolling::set_valued) {  // the impulse l over J went from one sphere to the other
    const Real inertia = p.step / p.inner.angular_impulse;
    const Vec<Real, 3> impulse = rolling_slots(chain)[bond].impulse;
    if (block.previous_step > 0)
      friction = friction + Real(0.5) * inertia * dot(impulse, previous.spin + spin);
    previous.spin = spin;
  } else if constexpr (P.rolling == Rolling::explicit_sign) {
    friction = friction +
               Real(0.5) * Real(block.previous_step) * (previous.rolling_power + dot(previous.moment, spin));
    HistoryOf<P, Real> history = history_before<P, Real>(chain, bond);
    advance_history<P, Real>(chain, history, now, Real(block.previous_step));
    previous.moment = sliding_moment(largest_rolling_moment<P, Real>(chain, history, now), spin);
    previous.rolling_power = dot(previous.moment, spin);
  }
}

template <Physics P, class Real>
void account_bond(const PackingBlock& block, const ChainBlock<P, Real>& chain, int bond,
                  const MovingSphere<Real, 3>& a, const MovingSphere<Real, 3>& b,
                  const BondAccount& account) {
  PreviousLoads<Real>& previous = as_values<PreviousLoads<Real>>(account.previous)[bond];
  Real& damping = *as_values<Real>(account.bond_damping);
  const auto add = [&](const BondConfiguration<Real, 3>& now) {
    if constexpr (P.solved == Solved::bonds) {
      account_solved<Real>(block, chain.parameters, now,
                           as_values<PreviousMotion<Real>>(account.previous)[bond], damping,
                           *as_values<Real>(account.scheme));
    } else if constexpr (P.damped) {
      account_dashpots<Real>(block, chain.parameters, a, b, now, previous, damping);
    }
    if constexpr (P.branches) {
      damping = damping + with_memory(chain, bond, [&](const HistoryOf<P, Real>& history, Real* strains) {
                  using Law = BondLaw<P>;
                  const MarchParameters<Real, 3>& p = chain.parameters;
                  const Real dt(block.previous_step);
                  return branch_dissipation<Law::keeps_strain, 3>(
                      p.bond, chain.branches, static_cast<const Real*>(strains),
                      Law::strains(p.bond, history, now, dt), dt > Real(0.0));
                });
    } else if constexpr (BondLaw<P>::dissipates) {
      const Real dt = Real(block.previous_step);
      damping = damping + BondLaw<P>::dissipated(chain.parameters.bond, chain.history[bond], now, dt);
    }
    if constexpr (P.fails) {  // a broken bond takes nothing in the kick to come
      const Real& intact = chain.history[bond].failure.intact;
      if constexpr (P.solved == Solved::bonds) {
        Real& counted = as_values<PreviousMotion<Real>>(account.previous)[bond].counted;
        counted = intact * counted;
      } else {
        scale(previous.loads, intact);
        previous.power = intact * previous.power;
      }
    }
    account_rolling<P, Real>(block, chain, bond, now, previous, *as_values<Real>(account.bond_friction));
  };
  with_configuration<P, Real>(chain, bond, a, b, add);
}

template <Physics P, class Real>
FIBERCHAIN_FLATTEN void account_packing(const PackingBlock& block, const BondAccount& account) {
  static_assert(numbers_of<PreviousLoads<Real>, Real> == bond_account_size &&
                numbers_of<PreviousMotion<Real>, Real> == bond_account_size);
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const BlockStorage<Real> rows(block);
  MovingSphere<Real, 3> before = rows.read_unloaded(0);
  for (int i = 0; i < block.bonds; ++i) {
    const MovingSphere<Real, 3> sphere = rows.read_unloaded(i + 1);
    account_bond<P, Real>(block, chain, i, before, sphere, account);
    before = sphere;
  }
}

}  // namespace fiberchain::dem
