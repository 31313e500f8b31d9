#include "dem/motion/lanes/rows.hpp"
#include "dem/motion/lanes/row_tables.hpp"

namespace fiberchain::dem {

const RowKernel* rows_sse2() { return rows_of<xsimd::batch<double, xsimd::sse2>>.kernels; }

}  // namespace fiberchain::dem
