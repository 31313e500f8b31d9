#include "dem/motion/kernels/packing_step.hpp"
#include "dem/simd/compiled_set.hpp"

// Bonds that break or yield, apart from the others so that these stay what they are.
namespace fiberchain::dem {

template <>
const PackingKernel* FailingKernels<compiled_set>::table() {
  return failing_kernels_of<CompiledReal>.kernels;
}

}  // namespace fiberchain::dem
