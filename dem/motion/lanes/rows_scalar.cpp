#include "dem/motion/lanes/rows.hpp"
#include "dem/motion/lanes/row_tables.hpp"

namespace fiberchain::dem {

const RowKernel* rows_scalar() { return rows_of<double>.kernels; }

}  // namespace fiberchain::dem
