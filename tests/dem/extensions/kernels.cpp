#include "dem/contact/kernels/instantiate.hpp"
#include "dem/simd/compiled_set.hpp"
#include "tests/dem/extensions/lists.hpp"

namespace fiberchain::dem {

template <>
const ContactKernel* ContactKernels<extensions::MoreLaws, WallShapes, compiled_set>::table() {
  return contacts_of<CompiledReal, extensions::MoreLaws, WallShapes>.kernels;
}

template <>
const ContactKernel* ContactKernels<ContactLaws, extensions::MoreShapes, compiled_set>::table() {
  return contacts_of<CompiledReal, ContactLaws, extensions::MoreShapes>.kernels;
}

}  // namespace fiberchain::dem
