#pragma once

#include "dem/assembly/assembly.hpp"
#include "dem/record/table.hpp"

// Bonds that broke, as NAME-breaks.csv records them.
namespace fiberchain::dem {

/// An empty one.
Table break_log_table();

/// A row for each bond that has broken since this was asked last.
Table break_log_rows(Assembly& assembly);

}  // namespace fiberchain::dem
