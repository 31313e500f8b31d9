#pragma once

#include "dem/contact/view.hpp"
#include "dem/motion/lanes/kernel.hpp"

namespace fiberchain::dem {

// Loops of one instruction set, in the order of contact_index().
const ContactKernel* contacts_scalar();
const ContactKernel* contacts_sse2();
const ContactKernel* contacts_avx2();
const ContactKernel* contacts_avx512();

/// The loops for a scene's contacts. The processor must have the instruction set.
const ContactKernel& contact_kernel(const ContactPhysics& physics, InstructionSet set);

}  // namespace fiberchain::dem
