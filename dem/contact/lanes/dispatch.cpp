#include "dem/contact/lanes/tables.hpp"

namespace fiberchain::dem {
namespace {

const ContactKernel* contacts(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512: return contacts_avx512();
    case InstructionSet::avx2: return contacts_avx2();
    case InstructionSet::sse2: return contacts_sse2();
    default: return contacts_scalar();
  }
}

}  // namespace

const ContactKernel& contact_kernel(const ContactPhysics& physics, InstructionSet set) {
  return contacts(set)[contact_index(physics)];
}

}  // namespace fiberchain::dem
