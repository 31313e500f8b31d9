#include "compare/bench/peak.hpp"

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

const PeakLoops& peak_loops(InstructionSet set) { return dem::kernel_of<PeakKernels>(set, 0); }

CorePeak measured_peak(InstructionSet set, const TimingBudget& budget) {
  const PeakLoops& loops = peak_loops(set);
  return {loops.fused,
          time_of(loops.multiply_add, budget),
          time_of(loops.divide, budget),
          time_of(loops.square_root, budget),
          time_of(loops.sine, budget),
          time_of(loops.arc_tangent, budget)};
}

}  // namespace fiberchain::compare
