#pragma once

#include "dem/simd/flatten.hpp"
#include "dem/motion/kernels/packing_kernel.hpp"
#include "dem/simd/transpose.hpp"
#include "dem/motion/leapfrog.hpp"

// Included by one source file an instruction set, as instantiate.hpp.
namespace fiberchain::dem {

template <Physics P, class Real>
ChainBlock<P, Real> chain_of(const PackingBlock& block) {
  return {block.bonds,
          {false, false},
          reinterpret_cast<MovingSphere<Real, 3>*>(block.scratch),
          reinterpret_cast<BondHistory<Real, 3>*>(block.history),
          reinterpret_cast<const NaturalEnds<Real, 3>*>(block.natural),
          *reinterpret_cast<const MarchParameters<Real, 3>*>(block.parameters),
          reinterpret_cast<Real*>(block.workspace),
          nullptr};
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
        motions_(starts_of<velocity_spin_size, Real>(block.motions, block)),
        loads_(starts_of<load_size, Real>(block.loads, block, block.first_loaded)),
        weight_{Real(block.weight[0]), Real(block.weight[1]), Real(block.weight[2])},
        radius_(places_.at[0][radius_offset]),
        oriented_(block.orientation != nullptr) {
    if (oriented_) orientation_ = starts_of<orientation_size, Real>(block.orientation, block);
  }

  bool oriented() const { return oriented_; }

  /// Sphere `i` without forces.
  MovingSphere<Real, 3> read_unloaded(std::ptrdiff_t i) const {
    MovingSphere<Real, 3> s;
    Real n[velocity_spin_size];
    load_rows<position_radius_size>(places_, i * position_radius_size, n);
    s.pose.position = {n[0], n[1], n[2]};
    load_rows<velocity_spin_size>(motions_, i * velocity_spin_size, n);
    s.velocity = {n[0], n[1], n[2]};
    s.spin = {n[spin_offset], n[spin_offset + 1], n[spin_offset + 2]};
    s.pose.orientation = {Real(1.0), {Real(0.0), Real(0.0), Real(0.0)}};
    if (oriented_) {
      load_rows<orientation_size>(orientation_, i * orientation_size, n);
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
    s.force = {n[0] + weight_[0], n[1] + weight_[1], n[2] + weight_[2]};
    s.moment = {n[moment_offset], n[moment_offset + 1], n[moment_offset + 2]};
    return s;
  }

  /// The loads from outside have acted.
  void write(std::ptrdiff_t i, const MovingSphere<Real, 3>& s) const {
    const Vec<Real, 3>&x = s.pose.position, &v = s.velocity, &w = s.spin;
    const Real place[] = {x[0], x[1], x[2], radius_}, motion[] = {v[0], v[1], v[2], w[0], w[1], w[2]};
    store_rows<position_radius_size>(place, places_, i * position_radius_size);
    store_rows<velocity_spin_size>(motion, motions_, i * velocity_spin_size);
    clear_rows<load_size>(loads_, i * load_size);
    if (oriented_) {
      const auto& q = s.pose.orientation;
      const Real orientation[] = {q.w, q.v[0], q.v[1], q.v[2]};
      store_rows<orientation_size>(orientation, orientation_, i * orientation_size);
    }
  }

 private:
  RowStarts<Real> places_, motions_, loads_, orientation_{};
  Vec<Real, 3> weight_;
  Real radius_;
  bool oriented_;
};

/// Inlined before the compiler asks what a function does: one that only fetches does nothing, and its calls would go.
inline __attribute__((always_inline)) void fetch_lines(const double* from, std::ptrdiff_t numbers) {
  for (std::ptrdiff_t n = 0; n < numbers; n += cache_line_size) __builtin_prefetch(from + n, 1, 2);
}

/// Fetches, a part with every sphere, the rows of a later block and the history of the next one: the rows are larger than the
/// caches, and the processor does not see them coming.
template <class Real>
inline __attribute__((always_inline)) void fetch_ahead(const PackingBlock& block, std::ptrdiff_t i) {
  constexpr std::ptrdiff_t lanes = lane_count<Real>;
  if (block.rows_ahead == 0) return;
  const std::ptrdiff_t row = block.first[0] + block.rows_ahead + i * lanes;
  fetch_lines(block.position_radius + row * position_radius_size, lanes * position_radius_size);
  fetch_lines(block.motions + row * velocity_spin_size, lanes * velocity_spin_size);
  constexpr std::ptrdiff_t history = sizeof(BondHistory<Real, 3>) / sizeof(double);
  if (block.next_history != nullptr) fetch_lines(block.next_history + i * history, history);
}

/// Position, and orientation where it is followed.
template <class Real>
void drift_row(const BlockStorage<Real>& rows, MovingSphere<Real, 3>& s, const Real& dt) {
  s.pose.position = s.pose.position + dt * s.velocity;
  if (rows.oriented()) turn(s.pose, dt * s.spin);
}

template <class Real>
double largest_lane(const Real& value) {
  if constexpr (lane_count<Real> == 1) {
    return value;
  } else {
    alignas(64) double numbers[lane_count<Real>];
    value.store_aligned(numbers);
    double largest = numbers[0];
    for (const double n : numbers) largest = largest < n ? n : largest;
    return largest;
  }
}

/// Bonds, then kick and drift: one sweep along the chains, the sphere whose second bond is still to come in registers.
template <Physics P, class Real>
Real sweep_packing(const PackingBlock& block) {
  using std::max;
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const auto flow = local_flow<P, Real>(reinterpret_cast<const Real*>(block.gradient));
  const BlockStorage<Real> rows(block);
  const Real previous_step(block.previous_step), dt = chain.parameters.step;
  Real fastest(0.0);
  const auto move = [&](int i, MovingSphere<Real, 3>& s) {
    kick<P>(s, chain.parameters, flow);
    drift_row(rows, s, dt);
    fastest = max(fastest, dot(s.velocity, s.velocity));
    rows.write(i, s);
  };
  MovingSphere<Real, 3> before = rows.read(0);
  for (int i = 1; i <= block.bonds; ++i) {
    fetch_ahead<Real>(block, i - 1);
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
  for (int i = 0; i < block.bonds; ++i) add_bond<P, Real>(chain, i, chain.spheres[i], chain.spheres[i + 1], previous_step);
  kick_together<P, Real>(chain);
  Real fastest(0.0);
  for (int i = 0; i <= block.bonds; ++i) {
    MovingSphere<Real, 3>& s = chain.spheres[i];
    drift_row(rows, s, chain.parameters.step);
    fastest = max(fastest, dot(s.velocity, s.velocity));
    rows.write(i, s);
  }
  return fastest;
}

template <Physics P, class Real>
FIBERCHAIN_FLATTEN double step_packing(const PackingBlock& block) {
  if constexpr (P.rolling == Rolling::set_valued) {
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

template <class Real>
struct PreviousLoads {
  BondLoads<Real, 3> loads;
  Real power;            ///< of the dashpots' loads [W]
  Vec<Real, 3> moment;   ///< of explicit rolling friction, on the first sphere [N m]
  Real rolling_power;    ///< [W]
  Vec<Real, 3> spin;     ///< relative, half a step before the kick [1/s]
};

/// A kick with a force takes force times the mean of the velocities before and after it, exactly: those of this step and of
/// the one before, whose loads are previous.
template <Physics P, class Real>
void account_bond(const PackingBlock& block, const ChainBlock<P, Real>& chain, int bond, const MovingSphere<Real, 3>& a,
               const MovingSphere<Real, 3>& b, const BondAccount& account) {
  const MarchParameters<Real, 3>& p = chain.parameters;
  PreviousLoads<Real>& previous = reinterpret_cast<PreviousLoads<Real>*>(account.previous)[bond];
  Real& damping = *reinterpret_cast<Real*>(account.bond_damping);
  Real& friction = *reinterpret_cast<Real*>(account.bond_friction);
  const Real half = Real(0.5) * Real(block.previous_step);
  const RelativeMotion<Real, 3> motion{b.velocity - a.velocity, Real(0.5) * (a.spin + b.spin), b.spin - a.spin};
  const BondVector<Real, 3> line = bond_vector<Real, 3>(b.pose.position - a.pose.position, p.inverse_length);
  damping = damping + half * (previous.power + power_taken(previous.loads, motion.velocity, a.spin, b.spin));
  previous.loads = act_at_middle(line.vector, dashpot_action(p.bond, line.vector, line.inverse_length * line.vector, motion));
  previous.power = power_taken(previous.loads, motion.velocity, a.spin, b.spin);
  if (block.previous_step == 0) damping = damping - Real(0.5) * p.step * previous.power;  // the first kick began half a step before the start
  if constexpr (P.rolling == Rolling::set_valued) {  // the impulse l over J went from one sphere to the other
    const Real inertia = p.step / p.angular_impulse;
    const Vec<Real, 3> impulse = rolling_slots(chain)[bond].impulse;
    if (block.previous_step > 0) friction = friction + Real(0.5) * inertia * dot(impulse, previous.spin + motion.relative_spin);
    previous.spin = motion.relative_spin;
  } else if constexpr (P.rolling == Rolling::explicit_sign) {
    friction = friction + half * (previous.rolling_power + dot(previous.moment, motion.relative_spin));
    BondHistory<Real, 3> history = chain.history[bond];
    advance(history, line, motion, Real(block.previous_step));
    previous.moment = sliding_moment(p.rolling_arm * abs(spring_tension(p.bond, history, line)), motion.relative_spin);
    previous.rolling_power = dot(previous.moment, motion.relative_spin);
  }
}

template <Physics P, class Real>
FIBERCHAIN_FLATTEN void account_packing(const PackingBlock& block, const BondAccount& account) {
  static_assert(sizeof(PreviousLoads<Real>) == bond_account_size * sizeof(Real));
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
  return (bonds + 1) * sizeof(MovingSphere<Real, 3>) / sizeof(double);
}

template <class Real>
struct PackingTable {
  PackingKernel kernels[built_physics.size()];
};

template <Physics P, class Real>
constexpr PackingKernel packing_kernel_of() {
  if constexpr (!built_for_packings(P)) {
    return {};
  } else {
    PackingKernel kernel{lane_count<Real>, workspace_reals<P, Real>, packing_scratch<P, Real>, step_packing<P, Real>,
                     snapshot_packing<P, Real>, nullptr};
    if constexpr (P.damped) kernel.account = account_packing<P, Real>;
    return kernel;
  }
}

template <class Real, std::size_t... I>
constexpr PackingTable<Real> packing_table(std::index_sequence<I...>) {
  return {{packing_kernel_of<built_physics[I], Real>()...}};
}

/// In the order of built_physics; what is not built in rows is empty.
template <class Real>
inline constexpr PackingTable<Real> packing_kernels_of = packing_table<Real>(std::make_index_sequence<built_physics.size()>{});

}  // namespace fiberchain::dem
