#include "dem/contact/lanes/instantiate.hpp"
#include "dem/contact/lanes/tables.hpp"

namespace fiberchain::dem {

const ContactKernel* contacts_avx512() { return contacts_of<xsimd::batch<double, xsimd::avx512f>>.kernels; }

}  // namespace fiberchain::dem
