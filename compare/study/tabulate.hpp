#pragma once

#include <string>
#include <vector>

#include "dem/record/errors.hpp"
#include "dem/record/table.hpp"

namespace fiberchain::compare {

/// Names of a row's columns, in order.
inline std::vector<std::string> names_of(const dem::NamedRow& row) {
  std::vector<std::string> names;
  for (const auto& [name, cell] : row) names.emplace_back(name);
  return names;
}

/// `rest` behind `first`, of column names or of cells.
template <class List>
List joined(List first, const List& rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

/// Table with a row for each item; the first row names all columns.
/// @throws dem::TableError if there is no item, or a row has a column that the first has not
template <class Items, class RowOf>
dem::Table tabulate(const Items& items, const RowOf& row_of) {
  if (std::empty(items)) throw dem::TableError("a table of no items has no columns");
  dem::Table table(names_of(row_of(*std::begin(items))));
  for (const auto& item : items) table.append(row_of(item));
  return table;
}

/// Table of one row.
inline dem::Table table_of(const dem::NamedRow& row) {
  dem::Table table(names_of(row));
  table.append(row);
  return table;
}

}  // namespace fiberchain::compare
