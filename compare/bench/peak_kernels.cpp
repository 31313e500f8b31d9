#include "compare/bench/peak_loops.hpp"
#include "dem/simd/compiled_set.hpp"

namespace fiberchain::compare {

template <>
const PeakLoops* PeakKernels<dem::compiled_set>::table() {
  static const PeakLoops loops = peak_loops_of<dem::CompiledReal>();
  return &loops;
}

}  // namespace fiberchain::compare
