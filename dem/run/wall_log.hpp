#pragma once

#include "dem/assembly/assembly.hpp"
#include "dem/record/table.hpp"

// What fibers do to walls, as NAME-walls.csv records it.
namespace fiberchain::dem {

/// An empty one.
Table wall_log_table();

/// A row for each wall, of the interval that ends now.
Table wall_log_rows(const Assembly& assembly);

}  // namespace fiberchain::dem
