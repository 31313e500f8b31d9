#include "dem/motion/lanes/instantiate.hpp"
#include "dem/motion/lanes/tables.hpp"

namespace fiberchain::dem {

const LaneKernel* kernels_sse2() { return kernels_of<xsimd::batch<double, xsimd::sse2>>.kernels; }

}  // namespace fiberchain::dem
