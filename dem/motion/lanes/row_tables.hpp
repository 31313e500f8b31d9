#pragma once

#include "dem/motion/lanes/row_kernel.hpp"

namespace fiberchain::dem {

// Kernels of one instruction set, in the order of built_physics.
const RowKernel* rows_scalar();
const RowKernel* rows_sse2();
const RowKernel* rows_avx2();
const RowKernel* rows_avx512();

}  // namespace fiberchain::dem
