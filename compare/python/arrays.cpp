#include "compare/python/arrays.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <string>

#include "dem/record/columns.hpp"

namespace fiberchain::python {
namespace {

using dem::Cell;

py::object texts_of(const dem::Table& table, const std::string& column) {
  py::list all;
  for (std::size_t row = 0; row < table.rows().size(); ++row) all.append(table.text(row, column));
  return py::module_::import("numpy").attr("array")(all, py::arg("dtype") = py::str("U"));
}

py::object numbers_of(const dem::Table& table, const std::string& column) {
  std::vector<double> all;
  for (std::size_t row = 0; row < table.rows().size(); ++row) all.push_back(table.number(row, column));
  return array_of(std::move(all));
}

/// Floating point where some are missing.
py::object integers_of(const dem::Table& table, const std::string& column) {
  std::vector<std::int64_t> all;
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    const auto* integer = std::get_if<std::int64_t>(&table.at(row, column));
    if (integer == nullptr) return numbers_of(table, column);
    all.push_back(*integer);
  }
  return array_of(std::move(all));
}

}  // namespace

py::dtype record_type(const std::vector<Field>& fields, std::size_t size) {
  py::list names, formats, offsets;
  for (const Field& field : fields) {
    names.append(py::str(field.name));
    formats.append(py::str(field.format));
    offsets.append(py::int_(field.offset));
  }
  return py::dtype(names, formats, offsets, static_cast<py::ssize_t>(size));
}

py::dict dict_of(const dem::Table& table) {
  py::dict all;
  for (const std::string& column : table.columns()) {
    const dem::CellKind kind = dem::find_column(column).kind;
    all[py::str(column)] = kind == dem::CellKind::text      ? texts_of(table, column)
                           : kind == dem::CellKind::integer ? integers_of(table, column)
                                                            : numbers_of(table, column);
  }
  return all;
}

}  // namespace fiberchain::python
