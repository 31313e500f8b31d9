#include "dem/motion/kernels/packing_step.hpp"
#include "dem/simd/compiled_set.hpp"

namespace fiberchain::dem {

template <>
const PackingKernel* PackingKernels<compiled_set>::table() {
  return packing_kernels_of<CompiledReal>.kernels;
}

}  // namespace fiberchain::dem
