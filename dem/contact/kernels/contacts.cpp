#include "dem/contact/kernels/instantiate.hpp"
#include "dem/contact/laws/laws.hpp"
#include "dem/model/shapes/shapes.hpp"
#include "dem/simd/compiled_set.hpp"

namespace fiberchain::dem {

template <>
const ContactKernel* ContactKernels<ContactLaws, WallShapes, compiled_set>::table() {
  return contacts_of<CompiledReal, ContactLaws, WallShapes>.kernels;
}

}  // namespace fiberchain::dem
