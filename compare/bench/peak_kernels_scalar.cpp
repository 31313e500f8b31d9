#include "compare/bench/peak_loops.hpp"

namespace fiberchain::compare {

PeakLoops peak_kernels_scalar() { return peak_loops_of<double>(); }

}  // namespace fiberchain::compare
