#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// A tidy table: named columns from the dictionary, a row per run.
namespace fiberchain::dem {

struct Missing {
  friend bool operator==(Missing, Missing) = default;
};

/// One value. Quantities that do not exist for a row (a NaN, an empty text) are Missing.
using Cell = std::variant<Missing, double, std::int64_t, std::string>;

/// The number; Missing if it is not finite.
Cell known(double value);

/// A row by column name; columns it leaves out are Missing.
using NamedRow = std::vector<std::pair<std::string_view, Cell>>;

class Table {
 public:
  /// An empty table.
  /// @throws TableError on a name that is not in the dictionary or comes twice
  explicit Table(std::vector<std::string> columns);

  /// Appends a row; every cell must be of its column's kind (an integer may stand for a number).
  /// @throws TableError on an unknown or repeated name, or a cell of another kind
  void append(const NamedRow& row);

  const std::vector<std::string>& columns() const { return columns_; }
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }

  /// The cell in that row and column.
  /// @throws TableError if there is no such column or row
  const Cell& at(std::size_t row, std::string_view column) const;

  /// The number in that row and column; NaN if Missing.
  /// @throws TableError if there is none or it is text
  double number(std::size_t row, std::string_view column) const;

  /// The text in that row and column; "" if Missing.
  /// @throws TableError if there is none or it is not text
  const std::string& text(std::size_t row, std::string_view column) const;

  /// The same rows with only these columns, in this order.
  /// @throws TableError if a column is not in this table
  Table select(const std::vector<std::string>& columns) const;

 private:
  std::size_t index_of(std::string_view column) const;

  std::vector<std::string> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace fiberchain::dem
