#include "dem/contact/kernels/contact_kernel.hpp"

namespace fiberchain::dem {

const ContactKernel& contact_kernel(const ContactPhysics& physics, InstructionSet set) {
  return kernel_of<ContactKernels>(set, contact_index(physics));
}

}  // namespace fiberchain::dem
