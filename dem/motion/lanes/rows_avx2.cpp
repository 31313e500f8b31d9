#include "dem/motion/lanes/rows.hpp"
#include "dem/motion/lanes/row_tables.hpp"

namespace fiberchain::dem {

const RowKernel* rows_avx2() { return rows_of<xsimd::batch<double, xsimd::avx2>>.kernels; }

}  // namespace fiberchain::dem
