#include "dem/motion/lanes/instantiate.hpp"
#include "dem/motion/lanes/tables.hpp"

namespace fiberchain::dem {

const LaneKernel* kernels_avx512() { return kernels_of<xsimd::batch<double, xsimd::avx512f>>.kernels; }

}  // namespace fiberchain::dem
