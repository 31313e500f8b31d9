#pragma once

#include <xsimd/xsimd.hpp>

#include "dem/motion/kernels/chain_kernel.hpp"
#include "dem/motion/leapfrog.hpp"
#include "dem/simd/as_numbers.hpp"
#include "dem/simd/flatten.hpp"

// One chain, its spheres and bonds side by side in lanes: number n of sphere i stands at [n * stride + i].
// The last vector overlaps the one before; it is worked out first and stored last, so that both give the same
// numbers.
namespace fiberchain::dem {

/// A value type of Reals, each taken from (or put to) consecutive places `stride` doubles apart.
template <class Value, class Real>
Value load_along(const double* source, int stride, int i) {
  Value value;
  Real* numbers = as_numbers<Real>(value);
  for (std::size_t n = 0; n < numbers_of<Value, Real>; ++n)
    numbers[n] = Real::load_unaligned(source + n * stride + i);
  return value;
}

template <class Real, class Value>
void store_along(const Value& value, double* target, int stride, int i) {
  const Real* numbers = as_numbers<Real>(value);
  for (std::size_t n = 0; n < numbers_of<Value, Real>; ++n)
    numbers[n].store_unaligned(target + n * stride + i);
}

/// Calls store(i, make(i)) for vectors that cover 0 ... count - 1; count is at least the width.
template <class Real, class Make, class Store>
void cover(int count, const Make& make, const Store& store) {
  constexpr int width = static_cast<int>(Real::size);
  const auto last = make(count - width);
  for (int i = 0; i + width < count; i += width) store(i, make(i));
  store(count - width, last);
}

template <Physics P, class Real>
struct BondSlot {
  HistoryOf<P, Real> history;
  BondLoads<Real, P.dimension> loads;
};

/// The flow at step `n` of those to come.
template <Physics P, class Real>
LocalFlow<P, Real> flow_of_step(const ChainBatchView& block, int n) {
  return local_flow<P, Real>(
      as_values<Real>(block.gradients + static_cast<std::ptrdiff_t>(n) * block.gradient_stride));
}

template <Physics P, class Real>
void move_spheres_along(const ChainBatchView& block, const MarchParameters<Real, P.dimension>& p,
                        const LocalFlow<P, Real>& flow) {
  using Sphere = MovingSphere<Real, P.dimension>;
  const int stride = block.stride;
  cover<Real>(
      block.bonds + 1,
      [&](int i) {
        Sphere sphere = load_along<Sphere, Real>(block.spheres, stride, i);
        SphereStep<Real> own = p.inner;
        const Real mobile = Real::load_unaligned(block.mobile + i);
        own.impulse = own.impulse * mobile, own.angular_impulse = own.angular_impulse * mobile;
        if constexpr (P.fluid) {
          own.follow = own.follow * mobile, own.spin_follow = own.spin_follow * mobile;
          if (block.dead)
            add_load(sphere, load_along<EndLoad<Real, P.dimension>, Real>(block.dead, stride, i));
        }
        kick<P>(sphere, p, own, flow);
        drift(sphere, p.step);
        return sphere;
      },
      [&](int i, const Sphere& sphere) { store_along<Real>(sphere, block.spheres, stride, i); });
}

/// Bond loads go one place up, so that place i holds what the bond before sphere i does.
template <Physics P, class Real>
void evaluate_bonds_along(const ChainBatchView& block, const MarchParameters<Real, P.dimension>& p,
                          const Real& dt) {
  using Sphere = MovingSphere<Real, P.dimension>;
  using History = HistoryOf<P, Real>;
  const int stride = block.stride;
  cover<Real>(
      block.bonds,
      [&](int i) {
        BondSlot<P, Real> slot{load_along<History, Real>(block.history, stride, i), {}};
        const ChainBlock<P, Real> one{.bonds = 1,
                                      .clamps = {},
                                      .spheres = nullptr,
                                      .history = &slot.history,
                                      .natural = nullptr,
                                      .parameters = p};
        slot.loads = bond_step<P, Real>(one, 0, load_along<Sphere, Real>(block.spheres, stride, i),
                                        load_along<Sphere, Real>(block.spheres, stride, i + 1), dt);
        return slot;
      },
      [&](int i, const BondSlot<P, Real>& slot) {
        if constexpr (has_history<BondLaw<P>>) store_along<Real>(slot.history, block.history, stride, i);
        store_along<Real>(slot.loads, block.loads, stride, i + 1);
      });
}

template <Physics P, class Real>
void reduce_bond_loads_along(const ChainBatchView& block) {
  constexpr int Dim = P.dimension;
  using Loads = BondLoads<Real, Dim>;
  struct Forces {
    Vec<Real, Dim> force;
    Spin<Real, Dim> moment;
  };
  constexpr int first = numbers_of<MovingSphere<Real, Dim>, Real> - numbers_of<Forces, Real>;
  const int stride = block.stride;
  cover<Real>(
      block.bonds + 1,
      [&](int i) {
        const Loads before = load_along<Loads, Real>(block.loads, stride, i);
        const Loads after = load_along<Loads, Real>(block.loads, stride, i + 1);
        return Forces{after.force_on_first - before.force_on_first,
                      before.moment_on_second + after.moment_on_first};
      },
      [&](int i, const Forces& forces) {
        store_along<Real>(forces, block.spheres + first * stride, stride, i);
      });
}

/// Dead loads of the ends, added to the forces of the spheres there.
template <Physics P, class Real>
void load_ends_along(const ChainBatchView& block, const MarchParameters<Real, P.dimension>& p,
                     double steps_before) {
  constexpr int Dim = P.dimension;
  constexpr int first = numbers_of<MovingSphere<Real, Dim>, Real> - numbers_of<EndLoad<Real, Dim>, Real>;
  const Real factor = ramp_factor(p.ramp.rate, steps_before);
  const auto add = [&](const EndLoad<Real, Dim>& load, int sphere) {
    const Real* numbers = as_numbers<Real>(load);
    for (std::size_t n = 0; n < numbers_of<EndLoad<Real, Dim>, Real>; ++n) {
      block.spheres[(first + n) * block.stride + sphere] += numbers[n].get(0);
    }
  };
  add(blend(p.ramp.first_from, p.ramp.first_to, factor), 0);
  add(blend(p.ramp.last_from, p.ramp.last_to, factor), block.bonds);
}

template <Physics P, class Real>
void start_single_chain(const ChainBatchView& block) {
  const auto p = *as_values<MarchParameters<Real, P.dimension>>(block.parameters);
  evaluate_bonds_along<P, Real>(block, p, Real(0.0));
  reduce_bond_loads_along<P, Real>(block);
}

template <Physics P, class Real>
FIBERCHAIN_FLATTEN void march_single_chain(const ChainBatchView& block, double steps_before, int steps) {
  const auto p = *as_values<MarchParameters<Real, P.dimension>>(block.parameters);
  for (int n = 0; n < steps; ++n) {
    load_ends_along<P, Real>(block, p, steps_before + n);
    move_spheres_along<P, Real>(block, p, flow_of_step<P, Real>(block, n));
    evaluate_bonds_along<P, Real>(block, p, p.step);
    reduce_bond_loads_along<P, Real>(block);
  }
}

}  // namespace fiberchain::dem
