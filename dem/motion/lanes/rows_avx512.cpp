#include "dem/motion/lanes/rows.hpp"
#include "dem/motion/lanes/row_tables.hpp"

namespace fiberchain::dem {

const RowKernel* rows_avx512() { return rows_of<xsimd::batch<double, xsimd::avx512f>>.kernels; }

}  // namespace fiberchain::dem
