#pragma once

#include <span>
#include <string_view>

/// The one dictionary of column names: CSV headers, JSON keys and `fiberchain columns` all come from here.
namespace fiberchain::dem {

/// What the cells of a column hold. Every kind may also hold "missing".
enum class CellKind {
  number,   ///< double
  integer,  ///< 64-bit signed integer
  text      ///< UTF-8
};

struct Column {
  std::string_view name;     ///< full name, snake_case
  CellKind kind;             ///< type of the cells
  std::string_view unit;     ///< SI unit, "1" where dimensionless, "" for text
  std::string_view meaning;  ///< one sentence
};

/// Every column any table of the program may have, in the order they are documented.
std::span<const Column> all_columns();

/// The dictionary's entry of that name.
/// @throws TableError if there is none
const Column& find_column(std::string_view name);

/// "number", "integer" or "text".
std::string_view to_string(CellKind kind);

}  // namespace fiberchain::dem
