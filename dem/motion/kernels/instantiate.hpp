#pragma once

#include <cmath>
#include <utility>
#include <xsimd/xsimd.hpp>

#include "dem/motion/kernels/chain_kernel.hpp"
#include "dem/motion/kernels/single_chain_kernel.hpp"
#include "dem/motion/leapfrog.hpp"
#include "dem/simd/as_numbers.hpp"
#include "dem/simd/flatten.hpp"
#include "dem/simd/lane_count.hpp"

// Included by one source file an instruction set. Everything compiled there is a template on that set's
// number type: its symbols are its own, and no function of another file can be replaced by one with foreign
// instructions.
namespace fiberchain::dem {

template <Physics P, class Real>
ChainBlock<P, Real> typed(const ChainBatchView& block) {
  constexpr int Dim = P.dimension;
  ChainBlock<P, Real> chain{.bonds = block.bonds,
                            .clamps = block.clamps,
                            .spheres = as_values<MovingSphere<Real, Dim>>(block.spheres),
                            .history = as_values<HistoryOf<P, Real>>(block.history),
                            .natural = as_values<NaturalEnds<Real, Dim>>(block.natural),
                            .parameters = *as_values<MarchParameters<Real, Dim>>(block.parameters),
                            .workspace = as_values<Real>(block.workspace),
                            .dead = as_values<EndLoad<Real, Dim>>(block.dead)};
  set_memory(chain, block.history, block.memory);
  return chain;
}

template <Physics P, class Real>
void start_block(const ChainBatchView& block) {
  start_march<P, Real>(typed<P, Real>(block));
}

template <Physics P, class Real>
FIBERCHAIN_FLATTEN void march_block(const ChainBatchView& block, double steps_before, int steps) {
  const ChainBlock<P, Real> chain = typed<P, Real>(block);
  for (int n = 0; n < steps; ++n)
    march_step<P, Real>(chain, steps_before + n, flow_of_step<P, Real>(block, n));
}

template <Physics P, class Real>
void half_kick_block(const ChainBatchView& block, double steps_before, bool back) {
  half_kick<P, Real>(typed<P, Real>(block), steps_before, flow_of_step<P, Real>(block, 0), back);
}

template <Physics P, class Real>
constexpr auto half_kick_of() -> decltype(ChainKernel::half_kick) {
  if constexpr (P.solved == Solved::bonds) {
    return half_kick_block<P, Real>;
  } else {
    return nullptr;
  }
}

template <class Real>
struct KernelTable {
  ChainKernel kernels[built_physics.size()];
};

template <Physics P, class Real>
constexpr ChainKernel lane_kernel_of() {
  if constexpr (built_for_single_chain(P) && lane_count < Real >> 1) {
    return {.width = lane_count<Real>,
            .history = numbers_of<HistoryOf<P, double>>,
            .workspace = workspace_reals<P, Real>,
            .start = start_block<P, Real>,
            .march = march_block<P, Real>,
            .half_kick = half_kick_of<P, Real>(),
            .start_single_chain = start_single_chain<P, Real>,
            .march_single_chain = march_single_chain<P, Real>};
  } else {
    return {.width = lane_count<Real>,
            .history = numbers_of<HistoryOf<P, double>>,
            .workspace = workspace_reals<P, Real>,
            .start = start_block<P, Real>,
            .march = march_block<P, Real>,
            .half_kick = half_kick_of<P, Real>(),
            .start_single_chain = nullptr,
            .march_single_chain = nullptr};
  }
}

template <class Real, std::size_t... I>
constexpr KernelTable<Real> kernel_table(std::index_sequence<I...>) {
  return {{lane_kernel_of<built_physics[I], Real>()...}};
}

/// Kernels in the order of built_physics.
template <class Real>
inline constexpr KernelTable<Real> kernels_of =
    kernel_table<Real>(std::make_index_sequence<built_physics.size()>{});

}  // namespace fiberchain::dem
