#include "compare/bench/peak.hpp"

#include "dem/errors.hpp"

namespace fiberchain::compare {
namespace {

using dem::InstructionSet;

/// [s] of one operation on one double.
double time_of(const PeakLoop& loop, const TimingBudget& budget) {
  constexpr long rounds = 20000;
  volatile double sink = 0;
  const Timing timing = time_warm([&] { sink = loop.run(rounds, 0.7); }, budget);
  return timing.least / (static_cast<double>(rounds) * loop.operations);
}

}  // namespace

PeakLoops peak_loops(InstructionSet set) {
  dem::lane_kernel(dem::built_physics[0], set);  // throws where the processor lacks it
  switch (set) {
    case InstructionSet::avx512:
      return peak_kernels_avx512();
    case InstructionSet::avx2:
      return peak_kernels_avx2();
    case InstructionSet::sse2:
      return peak_kernels_sse2();
    default:
      return peak_kernels_scalar();
  }
}

CorePeak measured_peak(InstructionSet set, const TimingBudget& budget) {
  const PeakLoops loops = peak_loops(set);
  return {loops.fused,
          time_of(loops.multiply_add, budget),
          time_of(loops.divide, budget),
          time_of(loops.square_root, budget),
          time_of(loops.sine, budget),
          time_of(loops.arc_tangent, budget)};
}

}  // namespace fiberchain::compare
