#pragma once

#include "dem/motion/lanes/flatten.hpp"
#include "dem/motion/lanes/row_kernel.hpp"
#include "dem/motion/lanes/transpose.hpp"
#include "dem/motion/leapfrog.hpp"

// Included by one source file an instruction set, as instantiate.hpp.
namespace fiberchain::dem {

template <Physics P, class Real>
ChainBlock<P, Real> chain_of(const RowBlock& block) {
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
RowStarts<Real> starts_of(double* rows, const RowBlock& block, std::int64_t from = 0) {
  RowStarts<Real> starts;
  for (int k = 0; k < lane_count<Real>; ++k) starts.at[k] = rows + (block.first[k] - from) * N;
  return starts;
}

/// The rows of a block's spheres.
template <class Real>
class BlockRows {
 public:
  explicit BlockRows(const RowBlock& block)
      : places_(starts_of<place_numbers, Real>(block.places, block)),
        motions_(starts_of<motion_numbers, Real>(block.motions, block)),
        loads_(starts_of<load_numbers, Real>(block.loads, block, block.first_loaded)),
        weight_{Real(block.weight[0]), Real(block.weight[1]), Real(block.weight[2])},
        radius_(places_.at[0][place_radius]),
        oriented_(block.orientation != nullptr) {
    if (oriented_) orientation_ = starts_of<orientation_numbers, Real>(block.orientation, block);
  }

  bool oriented() const { return oriented_; }

  /// Sphere `i` without forces.
  MovingSphere<Real, 3> read_unloaded(std::ptrdiff_t i) const {
    MovingSphere<Real, 3> s;
    Real n[motion_numbers];
    load_rows<place_numbers>(places_, i * place_numbers, n);
    s.pose.position = {n[0], n[1], n[2]};
    load_rows<motion_numbers>(motions_, i * motion_numbers, n);
    s.velocity = {n[0], n[1], n[2]};
    s.spin = {n[motion_spin], n[motion_spin + 1], n[motion_spin + 2]};
    s.pose.orientation = {Real(1.0), {Real(0.0), Real(0.0), Real(0.0)}};
    if (oriented_) {
      load_rows<orientation_numbers>(orientation_, i * orientation_numbers, n);
      s.pose.orientation = {n[0], {n[1], n[2], n[3]}};
    }
    clear_forces(s);
    return s;
  }

  /// The loads from outside and its weight as its forces.
  MovingSphere<Real, 3> read(std::ptrdiff_t i) const {
    MovingSphere<Real, 3> s = read_unloaded(i);
    Real n[load_moment + 3];
    load_rows<load_moment + 3>(loads_, i * load_numbers, n);
    s.force = {n[0] + weight_[0], n[1] + weight_[1], n[2] + weight_[2]};
    s.moment = {n[load_moment], n[load_moment + 1], n[load_moment + 2]};
    return s;
  }

  /// The loads from outside have acted.
  void write(std::ptrdiff_t i, const MovingSphere<Real, 3>& s) const {
    const Vec<Real, 3>&x = s.pose.position, &v = s.velocity, &w = s.spin;
    const Real place[] = {x[0], x[1], x[2], radius_}, motion[] = {v[0], v[1], v[2], w[0], w[1], w[2]};
    store_rows<place_numbers>(place, places_, i * place_numbers);
    store_rows<motion_numbers>(motion, motions_, i * motion_numbers);
    clear_rows<load_numbers>(loads_, i * load_numbers);
    if (oriented_) {
      const auto& q = s.pose.orientation;
      const Real orientation[] = {q.w, q.v[0], q.v[1], q.v[2]};
      store_rows<orientation_numbers>(orientation, orientation_, i * orientation_numbers);
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
  for (std::ptrdiff_t n = 0; n < numbers; n += line_numbers) __builtin_prefetch(from + n, 1, 2);
}

/// Fetches, a part with every sphere, the rows of a later block and the history of the next one: the rows are larger than the
/// caches, and the processor does not see them coming.
template <class Real>
inline __attribute__((always_inline)) void fetch_ahead(const RowBlock& block, std::ptrdiff_t i) {
  constexpr std::ptrdiff_t lanes = lane_count<Real>;
  if (block.rows_ahead == 0) return;
  const std::ptrdiff_t row = block.first[0] + block.rows_ahead + i * lanes;
  fetch_lines(block.places + row * place_numbers, lanes * place_numbers);
  fetch_lines(block.motions + row * motion_numbers, lanes * motion_numbers);
  constexpr std::ptrdiff_t history = sizeof(BondHistory<Real, 3>) / sizeof(double);
  if (block.next_history != nullptr) fetch_lines(block.next_history + i * history, history);
}

/// Position, and orientation where it is followed.
template <class Real>
void drift_row(const BlockRows<Real>& rows, MovingSphere<Real, 3>& s, const Real& dt) {
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
Real sweep_rows(const RowBlock& block) {
  using std::max;
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const auto flow = local_flow<P, Real>(reinterpret_cast<const Real*>(block.gradient));
  const BlockRows<Real> rows(block);
  const Real led(block.led), dt = chain.parameters.step;
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
    add_bond<P, Real>(chain, i - 1, before, sphere, led);
    move(i - 1, before);
    before = sphere;
  }
  move(block.bonds, before);
  return fastest;
}

/// The same where velocities depend on each other.
template <Physics P, class Real>
Real step_rows_together(const RowBlock& block) {
  using std::max;
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const BlockRows<Real> rows(block);
  const Real led(block.led);
  for (int i = 0; i <= block.bonds; ++i) chain.spheres[i] = rows.read(i);
  for (int i = 0; i < block.bonds; ++i) add_bond<P, Real>(chain, i, chain.spheres[i], chain.spheres[i + 1], led);
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
FIBERCHAIN_FLATTEN double step_rows(const RowBlock& block) {
  if constexpr (P.rolling == Rolling::set_valued) {
    return largest_lane(step_rows_together<P, Real>(block));
  } else {
    return largest_lane(sweep_rows<P, Real>(block));
  }
}

template <Physics P, class Real>
void look_at_rows(const RowBlock& block) {
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const BlockRows<Real> rows(block);
  for (int i = 0; i <= block.bonds; ++i) chain.spheres[i] = rows.read(i);
  for (int i = 0; i < block.bonds; ++i) {
    add_bond<P, Real>(chain, i, chain.spheres[i], chain.spheres[i + 1], Real(block.led));
  }
}

template <class Real>
struct KeptWork {
  BondLoads<Real, 3> loads;
  Real power;            ///< of the dashpots' loads [W]
  Vec<Real, 3> moment;   ///< of explicit rolling friction, on the first sphere [N m]
  Real rolling_power;    ///< [W]
  Vec<Real, 3> spin;     ///< relative, half a step before the kick [1/s]
};

/// A kick with a force takes force times the mean of the velocities before and after it, exactly: those of this step and of
/// the one before, whose loads are kept.
template <Physics P, class Real>
void book_bond(const RowBlock& block, const ChainBlock<P, Real>& chain, int bond, const MovingSphere<Real, 3>& a,
               const MovingSphere<Real, 3>& b, const BondBook& book) {
  const MarchParameters<Real, 3>& p = chain.parameters;
  KeptWork<Real>& kept = reinterpret_cast<KeptWork<Real>*>(book.kept)[bond];
  Real& damping = *reinterpret_cast<Real*>(book.bond_damping);
  Real& friction = *reinterpret_cast<Real*>(book.bond_friction);
  const Real half = Real(0.5) * Real(block.led);
  const RelativeMotion<Real, 3> motion{b.velocity - a.velocity, Real(0.5) * (a.spin + b.spin), b.spin - a.spin};
  const BondVector<Real, 3> line = bond_vector<Real, 3>(b.pose.position - a.pose.position, p.inverse_length);
  damping = damping + half * (kept.power + power_taken(kept.loads, motion.velocity, a.spin, b.spin));
  kept.loads = act_at_middle(line.vector, dashpot_action(p.bond, line.vector, line.inverse_length * line.vector, motion));
  kept.power = power_taken(kept.loads, motion.velocity, a.spin, b.spin);
  if (block.led == 0) damping = damping - Real(0.5) * p.step * kept.power;  // the first kick began half a step before the start
  if constexpr (P.rolling == Rolling::set_valued) {  // the impulse l over J went from one sphere to the other
    const Real inertia = p.step / p.angular_impulse;
    const Vec<Real, 3> impulse = rolling_slots(chain)[bond].impulse;
    if (block.led > 0) friction = friction + Real(0.5) * inertia * dot(impulse, kept.spin + motion.relative_spin);
    kept.spin = motion.relative_spin;
  } else if constexpr (P.rolling == Rolling::explicit_sign) {
    friction = friction + half * (kept.rolling_power + dot(kept.moment, motion.relative_spin));
    BondHistory<Real, 3> history = chain.history[bond];
    advance(history, line, motion, Real(block.led));
    kept.moment = sliding_moment(p.rolling_arm * abs(spring_tension(p.bond, history, line)), motion.relative_spin);
    kept.rolling_power = dot(kept.moment, motion.relative_spin);
  }
}

template <Physics P, class Real>
FIBERCHAIN_FLATTEN void book_rows(const RowBlock& block, const BondBook& book) {
  static_assert(sizeof(KeptWork<Real>) == book_numbers * sizeof(Real));
  const ChainBlock<P, Real> chain = chain_of<P, Real>(block);
  const BlockRows<Real> rows(block);
  MovingSphere<Real, 3> before = rows.read_unloaded(0);
  for (int i = 0; i < block.bonds; ++i) {
    const MovingSphere<Real, 3> sphere = rows.read_unloaded(i + 1);
    book_bond<P, Real>(block, chain, i, before, sphere, book);
    before = sphere;
  }
}

template <Physics P, class Real>
std::size_t row_scratch(int bonds) {
  return (bonds + 1) * sizeof(MovingSphere<Real, 3>) / sizeof(double);
}

template <class Real>
struct RowTable {
  RowKernel kernels[built_physics.size()];
};

template <Physics P, class Real>
constexpr RowKernel row_kernel_of() {
  if constexpr (!built_in_rows(P)) {
    return {};
  } else {
    RowKernel kernel{lane_count<Real>, workspace_reals<P, Real>, row_scratch<P, Real>, step_rows<P, Real>,
                     look_at_rows<P, Real>, nullptr};
    if constexpr (P.damped) kernel.book = book_rows<P, Real>;
    return kernel;
  }
}

template <class Real, std::size_t... I>
constexpr RowTable<Real> row_table(std::index_sequence<I...>) {
  return {{row_kernel_of<built_physics[I], Real>()...}};
}

/// In the order of built_physics; what is not built in rows is empty.
template <class Real>
inline constexpr RowTable<Real> rows_of = row_table<Real>(std::make_index_sequence<built_physics.size()>{});

}  // namespace fiberchain::dem
