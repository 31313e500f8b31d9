#pragma once

#include <string_view>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/record/table.hpp"

// Rows of NAME-walls.csv and NAME-held.csv.
namespace fiberchain::dem {

/// The words that columns of what fibers do to one kind of thing begin with.
struct ForceColumns {
  std::string_view number, name;
  std::vector<std::string_view> own;  ///< behind the name
  std::string_view force[3], moment[3], force_peak, moment_peak, work, center[3];
};

Table force_table(const ForceColumns& columns);

/// Adds the row of an interval that ends now; its number counts from 1, `own` are the cells of columns.own.
void append_force_row(Table& table, const ForceColumns& columns, const Assembly& assembly, std::size_t number,
                      const std::string& name, std::vector<Cell> own, const WallSample& sample);

}  // namespace fiberchain::dem
