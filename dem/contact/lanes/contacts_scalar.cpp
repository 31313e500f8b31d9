#include "dem/contact/lanes/instantiate.hpp"
#include "dem/contact/lanes/tables.hpp"

namespace fiberchain::dem {

const ContactKernel* contacts_scalar() { return contacts_of<double>.kernels; }

}  // namespace fiberchain::dem
