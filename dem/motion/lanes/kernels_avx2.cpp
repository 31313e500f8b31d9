#include "dem/motion/lanes/instantiate.hpp"
#include "dem/motion/lanes/tables.hpp"

namespace fiberchain::dem {

const LaneKernel* kernels_avx2() { return kernels_of<xsimd::batch<double, xsimd::avx2>>.kernels; }

}  // namespace fiberchain::dem
