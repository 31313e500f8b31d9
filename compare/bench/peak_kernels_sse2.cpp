#include "compare/bench/peak_loops.hpp"

namespace fiberchain::compare {

PeakLoops peak_kernels_sse2() { return peak_loops_of<xsimd::batch<double, xsimd::sse2>>(); }

}  // namespace fiberchain::compare
