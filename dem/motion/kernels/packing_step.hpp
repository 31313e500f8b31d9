#pragma once

#include "dem/motion/kernels/packing_kernel.hpp"
#include "dem/motion/leapfrog.hpp"
#include "dem/simd/as_numbers.hpp"
#include "dem/simd/flatten.hpp"
#include "dem/simd/gather.hpp"
#include "dem/simd/transpose.hpp"

// Included by one source file an instruction set, as instantiate.hpp.
namespace fiberchain::dem {

/// Where the slots of the elimination lie: behind the spheres.
template <class Real>
double* slots_of(const PackingBlock& block) {
  return block.scratch + (block.bonds + 1) * sizeof(MovingSphere<Real, 3>) / sizeof(double);
}

template <Physics P, class Real>
ChainBlock<P, Real> chain_of(const PackingBlock& block) {
  return {.bonds = block.bonds,
          .clamps = {false, false},
          .spheres = as_values<MovingSphere<Real, 3>>(block.scratch),
          .history = as_values<HistoryOf<P, Real>>(block.history),
          .natural = as_values<NaturalEnds<Real, 3>>(block.natural),
          .parameters = *as_values<MarchParameters<Real, 3>>(block.parameters),
          .workspace = as_values<Real>(P.solved == Solved::bonds ? slots_of<Real>(block) : block.workspace)};
}

template <int N, class Real>
RowStarts<Real> starts_of(double* rows, const PackingBlock& block, std::int64_t from = 0) {
  RowStarts<Real> starts;
  for (int k = 0; k < lane_count<Real>; ++k) starts.at[k] = rows + (block.first[k] - from) * N;
  return starts;
}

/// The rows of a block's spheres.
template <class Real>
class BlockStorage {
 public:
  explicit BlockStorage(const PackingBlock& block)
      : places_(starts_of<position_radius_size, Real>(block.position_radius, block)),
        velocity_spin_(starts_of<velocity_spin_size, Real>(block.velocity_spin, block)),
        loads_(starts_of<load_size, Real>(block.loads, block, block.first_loaded)),
        weight_{Real(block.weight[0]), Real(block.weight[1]), Real(block.weight[2])},
        end_share_(block.end_share),
        bonds_(block.bonds),
        radius_(places_.at[0][radius_offset]),
        oriented_(block.orientation != nullptr) {
    if (oriented_) orientation_ = starts_of<quaternion_size, Real>(block.orientation, block);
  }

  bool oriented() const { return oriented_; }

  /// Sphere `i` without forces.
  MovingSphere<Real, 3> read_unloaded(std::ptrdiff_t i) const {
    MovingSphere<Real, 3> s;
    Real n[velocity_spin_size];
    load_rows<position_radius_size>(places_, i * position_radius_size, n);
    s.pose.position = {n[0], n[1], n[2]};
    load_rows<velocity_spin_size>(velocity_spin_, i * velocity_spin_size, n);
    s.velocity = {n[0], n[1], n[2]};
    s.spin = {n[spin_offset], n[spin_offset + 1], n[spin_offset + 2]};
    s.pose.orientation = {Real(1.0), {Real(0.0), Real(0.0), Real(0.0)}};
    if (oriented_) {
      load_rows<quaternion_size>(orientation_, i * quaternion_size, n);
      s.pose.orientation = {n[0], {n[1], n[2], n[3]}};
    }
    clear_forces(s);
    return s;
  }

  /// The loads from outside and its weight as its forces.
  MovingSphere<Real, 3> read(std::ptrdiff_t i) const {
    MovingSphere<Real, 3> s = read_unloaded(i);
    Real n[moment_offset + 3];
    load_rows<moment_offset + 3>(loads_, i * load_size, n);
    const Vec<Real, 3> weight = i == 0 || i == bonds_ ? end_share_ * weight_ : weight_;
    s.force = {n[0] + weight[0], n[1] + weight[1], n[2] + weight[2]};
    s.moment = {n[moment_offset], n[moment_offset + 1], n[moment_offset + 2]};
    return s;
  }

  /// The loads from outside have acted.
  void write(std::ptrdiff_t i, const MovingSphere<Real, 3>& s) const {
    const Vec<Real, 3>&x = s.pose.position, &v = s.velocity, &w = s.spin;
    const Real place[] = {x[0], x[1], x[2], radius_}, motion[] = {v[0], v[1], v[2], w[0], w[1], w[2]};
    store_rows<position_radius_size>(place, places_, i * position_radius_size);
    store_rows<velocity_spin_size>(motion, velocity_spin_, i * velocity_spin_size);
    clear_rows<load_size>(loads_, i * load_size);
    if (oriented_) {
      const auto& q = s.pose.orientation;
      const Real orientation[] = {q.w, q.v[0], q.v[1], q.v[2]};
      store_rows<quaternion_size>(orientation, orientation_, i * quaternion_size);
    }
  }

 private:
  RowStarts<Real> places_, velocity_spin_, loads_, orientation_{};
  Vec<Real, 3> weight_;
  Real end_share_;
  std::ptrdiff_t bonds_;
  Real radius_;
  bool oriented_;
};

/// Inlined before the compiler asks what a function does: one that only fetches does nothing, and its calls
/// would go.
inline __attribute__((always_inline)) void fetch_lines(const double* from, std::ptrdiff_t numbers) {
  for (std::ptrdiff_t n = 0; n < numbers; n += cache_line_size) __builtin_prefetch(from + n, 1, 2);
}

/// Fetches, a part with every sphere, the rows of a later block and the history of the next one: the rows are
/// larger than the caches, and the processor does not see them coming.
template <Physics P, class Real>
inline __attribute__((always_inline)) void fetch_ahead(const PackingBlock& block, std::ptrdiff_t i) {
  constexpr std::ptrdiff_t lanes = lane_count<Real>;
  if (block.rows_ahead == 0) return;
  const std::ptrdiff_t row = block.first[0] + block.rows_ahead + i * lanes;
  fetch_lines(block.position_radius + row * position_radius_size, lanes * position_radius_size);
  fetch_lines(block.velocity_spin + row * velocity_spin_size, lanes * velocity_spin_size);
  constexpr std::ptrdiff_t history = numbers_of<HistoryOf<P, Real>>;
  if (block.next_history != nullptr) fetch_lines(block.next_history + i * history, history);
}

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
    elimination.pass(before, i == 0, flow, bond_matrix<P, Real>(p, law, before, sphere), slots[i]);
    chain.spheres[i] = before;
    const Vec<Real, 3> V = sphere.velocity - before.velocity, r = sphere.pose.position - before.pose.position;
    bond_speed = max(bond_speed, dot(V, V));
    bond_length = max(bond_length, dot(r, r));
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
    if constexpr (BondLaw<P>::dissipates) {
      const Real dt = Real(block.previous_step);
      damping = damping + BondLaw<P>::dissipated(chain.parameters.bond, chain.history[bond], now, dt);
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

/// In the order of built_physics_of<form>: of a law from outside of the library.
template <BondForm form, class Real>
inline constexpr const auto& law_kernels_of = packing_table_of<built_physics_of<form>, Real>;

}  // namespace fiberchain::dem
