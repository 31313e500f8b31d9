#pragma once

#include "dem/motion/kernels/packing_kernel.hpp"
#include "dem/motion/leapfrog.hpp"
#include "dem/simd/as_numbers.hpp"
#include "dem/simd/gather.hpp"
#include "dem/simd/transpose.hpp"

// The spheres of a block of fibers between their rows and the lanes.
namespace fiberchain::dem {

/// Where the slots of the elimination lie: behind the spheres.
template <class Real>
double* slots_of(const PackingBlock& block) {
  return block.scratch + (block.bonds + 1) * sizeof(MovingSphere<Real, 3>) / sizeof(double);
}

template <Physics P, class Real>
ChainBlock<P, Real> chain_of(const PackingBlock& block) {
  ChainBlock<P, Real> chain{
      .bonds = block.bonds,
      .clamps = {false, false},
      .spheres = as_values<MovingSphere<Real, 3>>(block.scratch),
      .history = as_values<HistoryOf<P, Real>>(block.history),
      .natural = as_values<NaturalEnds<Real, 3>>(block.natural),
      .parameters = *as_values<MarchParameters<Real, 3>>(block.parameters),
      .workspace = as_values<Real>(P.solved == Solved::bonds ? slots_of<Real>(block) : block.workspace)};
  set_memory(chain, block.history, block.memory);
  if constexpr (P.fails) chain.parameters.bond.own[may_break_place] = Real(block.may_break ? 1.0 : 0.0);
  return chain;
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
  const std::ptrdiff_t history = P.branches ? static_cast<std::ptrdiff_t>(block.memory.bond) * lanes
                                            : static_cast<std::ptrdiff_t>(numbers_of<HistoryOf<P, Real>>);
  if (block.next_history != nullptr) fetch_lines(block.next_history + i * history, history);
}

}  // namespace fiberchain::dem
