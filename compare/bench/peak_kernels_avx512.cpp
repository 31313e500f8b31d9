#include "compare/bench/peak_loops.hpp"

namespace fiberchain::compare {

PeakLoops peak_kernels_avx512() { return peak_loops_of<xsimd::batch<double, xsimd::avx512f>>(); }

}  // namespace fiberchain::compare
