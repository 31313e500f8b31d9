#include "dem/motion/kernels/instantiate.hpp"
#include "dem/simd/compiled_set.hpp"

namespace fiberchain::dem {

template <>
const ChainKernel* ChainKernels<compiled_set>::table() {
  return kernels_of<CompiledReal>.kernels;
}

}  // namespace fiberchain::dem
