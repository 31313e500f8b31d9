#include "dem/record/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/record/columns.hpp"
#include "dem/record/errors.hpp"

namespace fiberchain::dem {
namespace {

/// The cell as its column wants it: an integer in a number's place becomes a number; NaN and "" become
/// Missing.
Cell fitted(const Column& column, const Cell& cell) {
  if (std::holds_alternative<Missing>(cell)) return cell;
  const bool is_text = std::holds_alternative<std::string>(cell);
  const bool is_integer = std::holds_alternative<std::int64_t>(cell);
  if (is_text != (column.kind == CellKind::text) || (column.kind == CellKind::integer && !is_integer)) {
    throw TableError(fmt::format("column '{}' holds {}s only", column.name, to_string(column.kind)));
  }
  if (is_text && std::get<std::string>(cell).empty()) return Missing{};
  if (column.kind != CellKind::number) return cell;
  const double value =
      is_integer ? static_cast<double>(std::get<std::int64_t>(cell)) : std::get<double>(cell);
  return std::isnan(value) ? Cell(Missing{}) : Cell(value);
}

}  // namespace

Cell known(double value) { return std::isfinite(value) ? Cell(value) : Cell(Missing{}); }

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    find_column(columns_[i]);
    const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(columns_.begin(), end, columns_[i]) != end) {
      throw TableError("column '" + columns_[i] + "' comes twice");
    }
  }
}

void Table::append(const NamedRow& row) {
  std::vector<Cell> cells(columns_.size());
  std::vector<bool> set(columns_.size(), false);
  for (const auto& [name, cell] : row) {
    const std::size_t i = index_of(name);
    if (set[i]) throw TableError("column '" + columns_[i] + "' comes twice in a row");
    set[i] = true;
    cells[i] = fitted(find_column(name), cell);
  }
  rows_.push_back(std::move(cells));
}

std::size_t Table::index_of(std::string_view column) const {
  const auto found = std::ranges::find(columns_, column);
  if (found == columns_.end()) throw TableError(fmt::format("the table has no column '{}'", column));
  return static_cast<std::size_t>(found - columns_.begin());
}

const Cell& Table::at(std::size_t row, std::string_view column) const {
  if (row >= rows_.size()) throw TableError(fmt::format("the table has no row {}", row));
  return rows_[row][index_of(column)];
}

double Table::number(std::size_t row, std::string_view column) const {
  const Cell& cell = at(row, column);
  if (std::holds_alternative<Missing>(cell)) return std::numeric_limits<double>::quiet_NaN();
  if (const auto* value = std::get_if<double>(&cell)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*value);
  throw TableError(fmt::format("column '{}' holds text", column));
}

const std::string& Table::text(std::size_t row, std::string_view column) const {
  static const std::string nothing;
  const Cell& cell = at(row, column);
  if (std::holds_alternative<Missing>(cell)) return nothing;
  if (const auto* value = std::get_if<std::string>(&cell)) return *value;
  throw TableError(fmt::format("column '{}' holds no text", column));
}

Table Table::select(const std::vector<std::string>& columns) const {
  Table chosen(columns);
  std::vector<std::size_t> from;
  for (const std::string& column : columns) from.push_back(index_of(column));
  for (const auto& row : rows_) {
    auto& cells = chosen.rows_.emplace_back();
    for (const std::size_t i : from) cells.push_back(row[i]);
  }
  return chosen;
}

}  // namespace fiberchain::dem
