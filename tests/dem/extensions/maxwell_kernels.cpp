#include "dem/motion/kernels/packing_step.hpp"
#include "dem/simd/compiled_set.hpp"
#include "tests/dem/extensions/maxwell_bond.hpp"

namespace fiberchain::dem {

template <>
template <>
const PackingKernel* LawKernels<maxwell_form>::Of<compiled_set>::table() {
  return law_kernels_of<maxwell_form, CompiledReal>.kernels;
}

}  // namespace fiberchain::dem
