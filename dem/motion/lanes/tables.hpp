#pragma once

#include "dem/motion/lanes/kernel.hpp"

namespace fiberchain::dem {

// Kernels of one instruction set, in the order of built_physics.
const LaneKernel* kernels_scalar();
const LaneKernel* kernels_sse2();
const LaneKernel* kernels_avx2();
const LaneKernel* kernels_avx512();

}  // namespace fiberchain::dem
