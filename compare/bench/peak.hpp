#pragma once

#include <vector>

#include "compare/bench/timing.hpp"
#include "dem/simd/instruction_set.hpp"

// What one core does at most: throughput of independent operations on full vectors, in registers.
namespace fiberchain::compare {

/// The loops of one instruction set: each does `rounds` rounds on independent vectors and returns a number
/// that depends on all of them. `operations` is how many operations on doubles a round is.
struct PeakLoop {
  double (*run)(long rounds, double start);
  int operations;
};

struct PeakLoops {
  bool fused;
  PeakLoop multiply_add;  ///< as many additions as multiplications; one operation where they are fused
  PeakLoop divide, square_root, sine, arc_tangent;
};

/// The loops of one instruction set.
template <dem::InstructionSet set>
struct PeakKernels {
  static const PeakLoops* table();
};

const PeakLoops& peak_loops(dem::InstructionSet set);

/// Least time of one operation on one double [s].
struct CorePeak {
  bool fused;  ///< an addition of a product is one instruction
  double multiply_add, divide, square_root;
  double sine;  ///< or cosine, the mean of both
  double arc_tangent;
};

/// Measured now, on this core.
CorePeak measured_peak(dem::InstructionSet set, const TimingBudget& budget);

}  // namespace fiberchain::compare
