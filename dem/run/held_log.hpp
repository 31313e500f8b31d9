#pragma once

#include "dem/assembly/assembly.hpp"
#include "dem/record/table.hpp"

// What fibers do to what holds and loads them, as NAME-held.csv records it.
namespace fiberchain::dem {

/// An empty one.
Table held_log_table();

/// A row for each grip, of the interval that ends now.
Table held_log_rows(const Assembly& assembly);

}  // namespace fiberchain::dem
