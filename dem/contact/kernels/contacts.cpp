#include "dem/contact/kernels/instantiate.hpp"
#include "dem/simd/compiled_set.hpp"

namespace fiberchain::dem {

template <>
const ContactKernel* ContactKernels<compiled_set>::table() {
  return contacts_of<CompiledReal>.kernels;
}

}  // namespace fiberchain::dem
