#include "dem/motion/lanes/instantiate.hpp"
#include "dem/motion/lanes/tables.hpp"

namespace fiberchain::dem {

const LaneKernel* kernels_scalar() { return kernels_of<double>.kernels; }

}  // namespace fiberchain::dem
