#include "compare/bench/peak_loops.hpp"

namespace fiberchain::compare {

PeakLoops peak_kernels_avx2() { return peak_loops_of<xsimd::batch<double, xsimd::avx2>>(); }

}  // namespace fiberchain::compare
