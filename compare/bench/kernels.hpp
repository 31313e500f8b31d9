#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/bench/count.hpp"
#include "compare/bench/peak.hpp"
#include "compare/bench/problems.hpp"
#include "compare/bench/swinging_chain.hpp"
#include "compare/figures/figure.hpp"
#include "dem/record/table.hpp"

// The inner loops: how long a bond-step takes, what the operations in it must take at least, and what a scene
// saves that lacks something. Chains of 11 spheres.
namespace fiberchain::compare {

/// One inner loop by one instruction set, timed in turns with all the others.
struct KernelTime {
  dem::Physics physics;
  dem::InstructionSet set;
  int lanes;
  double ensemble;         ///< [s] of a bond-step, all lanes full
  double lone;             ///< [s] of a bond-step, one chain alone
  OperationCount count{};  ///< of a bond-step
};

/// Every physics built, by every instruction set that this processor has; quick: by the widest and one lane
/// at a time.
std::vector<KernelTime> kernel_times(const BenchOptions& options);

/// What bounds a loop.
struct KernelBound {
  double
      arithmetic;  ///< [s] a bond-step's additions, multiplications and circular functions take at the peak
  double divider;  ///< [s] its divisions and square roots take, which one unit does beside the others

  double least() const { return arithmetic > divider ? arithmetic : divider; }
};

KernelBound bound_of(const OperationCount& count, const CorePeak& peak);

/// Largest time wanted of the damped incremental loop by the widest lanes, and of a lone chain [s]: planar 2
/// and 15 ns, spatial 10 and 60 ns; nothing for the other loops.
struct KernelTarget {
  double ensemble, lone;
};
std::optional<KernelTarget> target_of(const dem::Physics& physics);

struct MeasuredPeak {
  dem::InstructionSet set;
  CorePeak peak;
};

std::vector<MeasuredPeak> measured_peaks(const std::vector<KernelTime>& times, const BenchOptions& options);

/// The loops by the widest lanes, and those that take a lone chain fastest where a time is wanted of it.
std::vector<KernelTime> widest_or_wanted(const std::vector<KernelTime>& times);

dem::Table kernel_table(const std::vector<KernelTime>& times, const std::vector<MeasuredPeak>& peaks);
dem::Table peak_table(const std::vector<MeasuredPeak>& peaks);

/// Time of a bond-step against the bound, every loop by every instruction set.
Figure kernel_figure(const std::vector<KernelTime>& times, const std::vector<MeasuredPeak>& peaks);

}  // namespace fiberchain::compare
