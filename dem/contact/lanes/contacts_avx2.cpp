#include "dem/contact/lanes/instantiate.hpp"
#include "dem/contact/lanes/tables.hpp"

namespace fiberchain::dem {

const ContactKernel* contacts_avx2() { return contacts_of<xsimd::batch<double, xsimd::avx2>>.kernels; }

}  // namespace fiberchain::dem
