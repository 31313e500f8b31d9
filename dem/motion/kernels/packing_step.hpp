#pragma once

#include "dem/motion/kernels/packing_account.hpp"
#include "dem/simd/flatten.hpp"

// Included by one source file an instruction set, as instantiate.hpp.
namespace fiberchain::dem {

/// Position, and orientation where it is followed.
template <class Real>
void drift_row(const BlockStorage<Real>& rows, MovingSphere<Real, 3>& s, const Real& dt) {
  s.pose.position = s.pose.position + dt * s.velocity;
  if (rows.oriented()) turn(s.pose, dt * s.spin);
}

/// Bonds, then kick and drift: one sweep along the chains, the sphere whose second bond is still to come in
/// registers.
template <Physics P, class Real>
Real sweep_packing(const PackingBlock& block) {
  using std::max;
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const auto flow = local_flow<P, Real>(as_values<Real>(block.gradient));
  const BlockStorage<Real> rows(block);
  const Real previous_step(block.previous_step), dt = chain.parameters.step;
  Real fastest(0.0);
  const auto move = [&](int i, MovingSphere<Real, 3>& s) {
    kick<P>(s, chain.parameters, chain.step_of(i), flow);
    drift_row(rows, s, dt);
    fastest = max(fastest, dot(s.velocity, s.velocity));
    rows.write(i, s);
  };
  MovingSphere<Real, 3> before = rows.read(0);
  for (int i = 1; i <= block.bonds; ++i) {
    fetch_ahead<P, Real>(block, i - 1);
    MovingSphere<Real, 3> sphere = rows.read(i);
    add_bond<P, Real>(chain, i - 1, before, sphere, previous_step);
    move(i - 1, before);
    before = sphere;
  }
  move(block.bonds, before);
  return fastest;
}

/// The same where velocities depend on each other.
template <Physics P, class Real>
Real step_packing_together(const PackingBlock& block) {
  using std::max;
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const BlockStorage<Real> rows(block);
  const Real previous_step(block.previous_step);
  for (int i = 0; i <= block.bonds; ++i) chain.spheres[i] = rows.read(i);
  for (int i = 0; i < block.bonds; ++i)
    add_bond<P, Real>(chain, i, chain.spheres[i], chain.spheres[i + 1], previous_step);
  kick_together<P, Real>(chain, LocalFlow<P, Real>{});
  Real fastest(0.0);
  for (int i = 0; i <= block.bonds; ++i) {
    MovingSphere<Real, 3>& s = chain.spheres[i];
    drift_row(rows, s, chain.parameters.step);
    fastest = max(fastest, dot(s.velocity, s.velocity));
    rows.write(i, s);
  }
  return fastest;
}

/// The same where bonds are solved for: forces, matrices and elimination in one sweep to the last sphere,
/// kick and drift in one back.
template <Physics P, class Real>
Real step_packing_solved(const PackingBlock& block) {
  using std::max;
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const MarchParameters<Real, 3>& p = chain.parameters;
  const auto flow = local_flow<P, Real>(as_values<Real>(block.gradient));
  const BlockStorage<Real> rows(block);
  const Real previous_step(block.previous_step);
  const BondParameters<Real> law = solved_dashpots<P, Real>(p);
  auto* slots = as_values<EliminationSlot<Real, 3>>(slots_of<Real>(block));
  Elimination<P, Real> elimination(p);
  Real fastest(0.0), bond_speed(0.0), bond_length(0.0);
  MovingSphere<Real, 3> before = rows.read(0);
  for (int i = 0; i < block.bonds; ++i) {
    fetch_ahead<P, Real>(block, i);
    MovingSphere<Real, 3> sphere = rows.read(i + 1);
    add_bond<P, Real>(chain, i, before, sphere, previous_step);
    elimination.pass(before, i == 0, flow, bond_matrix<P, Real>(chain, law, i, before, sphere), slots[i]);
    chain.spheres[i] = before;
    const Vec<Real, 3> V = sphere.velocity - before.velocity, r = sphere.pose.position - before.pose.position;
    if constexpr (P.fails) {
      const auto whole = chain.history[i].failure.intact > Real(0.0);
      bond_speed = max(bond_speed, select(whole, dot(V, V), Real(0.0)));
      bond_length = max(bond_length, select(whole, dot(r, r), Real(0.0)));
    } else {
      bond_speed = max(bond_speed, dot(V, V));
      bond_length = max(bond_length, dot(r, r));
    }
    before = sphere;
  }
  elimination.finish(before, flow, slots[block.bonds]);
  chain.spheres[block.bonds] = before;
  substitute_back<Real, 3>(slots, block.bonds, [&](int i, const Vec<Real, 6>& change) {
    MovingSphere<Real, 3>& s = chain.spheres[i];
    add_change(s, change, Real(1.0));
    drift_row(rows, s, p.step);
    fastest = max(fastest, dot(s.velocity, s.velocity));
    rows.write(i, s);
  });
  BondExtremes& most = *block.extremes;
  most.relative_speed = std::max(most.relative_speed, std::sqrt(largest_lane(bond_speed)));
  most.length = std::max(most.length, std::sqrt(largest_lane(bond_length)));
  return fastest;
}

template <Physics P, class Real>
void half_kick_packing(const PackingBlock& block, bool back) {
  half_kick<P, Real>(chain_of<P, Real>(block), 0, local_flow<P, Real>(as_values<Real>(block.gradient)), back);
}

template <Physics P, class Real>
constexpr auto half_kick_packing_of() -> decltype(PackingKernel::half_kick) {
  if constexpr (P.solved == Solved::bonds) {
    return half_kick_packing<P, Real>;
  } else {
    return nullptr;
  }
}

template <Physics P, class Real>
FIBERCHAIN_FLATTEN double step_packing(const PackingBlock& block) {
  if constexpr (P.solved == Solved::bonds) {
    return largest_lane(step_packing_solved<P, Real>(block));
  } else if constexpr (P.rolling == Rolling::set_valued) {
    return largest_lane(step_packing_together<P, Real>(block));
  } else {
    return largest_lane(sweep_packing<P, Real>(block));
  }
}

template <Physics P, class Real>
void snapshot_packing(const PackingBlock& block) {
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const BlockStorage<Real> rows(block);
  for (int i = 0; i <= block.bonds; ++i) chain.spheres[i] = rows.read(i);
  for (int i = 0; i < block.bonds; ++i) {
    add_bond<P, Real>(chain, i, chain.spheres[i], chain.spheres[i + 1], Real(block.previous_step));
  }
}

template <Physics P, class Real>
std::size_t packing_scratch(int bonds) {
  constexpr std::size_t slot = P.solved == Solved::bonds ? sizeof(EliminationSlot<Real, 3>) : 0;
  return (bonds + 1) * (sizeof(MovingSphere<Real, 3>) + slot) / sizeof(double);
}

/// Kept from step to step.
template <Physics P, class Real>
std::size_t packing_workspace(int bonds) {
  return P.solved == Solved::bonds ? 0 : workspace_reals<P, Real>(bonds);
}

template <std::size_t count>
struct PackingTable {
  PackingKernel kernels[count];
};

template <Physics P, class Real>
constexpr PackingKernel packing_kernel_of() {
  if constexpr (!built_for_packings(P)) {
    return {};
  } else {
    PackingKernel kernel{.width = lane_count<Real>,
                         .history = numbers_of<HistoryOf<P, double>>,
                         .workspace = packing_workspace<P, Real>,
                         .scratch = packing_scratch<P, Real>,
                         .step = step_packing<P, Real>,
                         .snapshot = snapshot_packing<P, Real>,
                         .half_kick = half_kick_packing_of<P, Real>(),
                         .account = nullptr};
    if constexpr (P.damped || BondLaw<P>::dissipates) kernel.account = account_packing<P, Real>;
    return kernel;
  }
}

template <const auto& list, class Real, std::size_t... I>
constexpr PackingTable<sizeof...(I)> packing_table(std::index_sequence<I...>) {
  return {{packing_kernel_of<list[I], Real>()...}};
}

/// Kernels in the order of a list of physics; empty where a physics is not built for packings.
template <const auto& list, class Real>
inline constexpr auto packing_table_of = packing_table<list, Real>(std::make_index_sequence<list.size()>{});

/// In the order of built_physics.
template <class Real>
inline constexpr const auto& packing_kernels_of = packing_table_of<built_physics, Real>;

/// In the order of failing_physics.
template <class Real>
inline constexpr const auto& failing_kernels_of = packing_table_of<failing_physics, Real>;

/// In the order of built_physics_of<form>: of a law from outside of the library.
template <BondForm form, class Real>
inline constexpr const auto& law_kernels_of = packing_table_of<built_physics_of<form>, Real>;

}  // namespace fiberchain::dem
