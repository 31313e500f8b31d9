#include "dem/scene/fiber_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>

#include "dem/files/csv_reader.hpp"
#include "dem/files/numbers.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/scene/yaml_document.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::array<std::string_view, 9> names{"x", "y", "z", "ux", "uy", "uz", "vx", "vy", "vz"};
constexpr std::size_t required = 6;

/// Index in `names` of each field of the header.
std::vector<std::size_t> columns_of(const CsvReader& reader, const std::vector<std::string>& header) {
  std::vector<std::size_t> columns;
  for (const std::string& text : header) {
    const std::string_view field = trimmed(text);
    const auto found = std::ranges::find(names, field);
    if (found == names.end()) {
      reader.fail(fmt::format(
          "column '{}' is unknown; columns are x, y, z, ux, uy, uz and, if fibers move, vx, vy, vz",
          printable(field)));
    }
    const auto column = static_cast<std::size_t>(found - names.begin());
    if (std::ranges::find(columns, column) != columns.end())
      reader.fail(fmt::format("column '{}' stands twice", field));
    columns.push_back(column);
  }
  const bool moves = std::ranges::any_of(columns, [](std::size_t c) { return c >= required; });
  for (std::size_t c = 0; c < (moves ? names.size() : required); ++c) {
    if (std::ranges::find(columns, c) == columns.end())
      reader.fail(fmt::format("column '{}' is missing", names[c]));
  }
  return columns;
}

FiberStart start_of(const CsvReader& reader, const std::vector<std::size_t>& columns,
                    const std::vector<std::string>& fields) {
  if (fields.size() != columns.size()) {
    reader.fail(fmt::format("has {} fields; allowed: {}, as many as columns", fields.size(), columns.size()));
  }
  std::array<double, names.size()> value{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto number = parse_number(trimmed(fields[i]));
    if (!number || !std::isfinite(*number)) {
      reader.fail(fmt::format("column '{}': '{}' is not allowed; allowed: a number that is finite",
                              names[columns[i]], printable(trimmed(fields[i]))));
    }
    value[columns[i]] = *number;
  }
  const FiberStart start{
      {value[0], value[1], value[2]}, {value[3], value[4], value[5]}, {value[6], value[7], value[8]}};
  const double length = norm(start.direction);
  if (!(std::abs(length - 1) < 1e-3)) {
    reader.fail(
        fmt::format("columns 'ux', 'uy', 'uz': the direction's length is {:.6g}; allowed: 1", length));
  }
  return start;
}

}  // namespace

std::vector<FiberStart> read_fiber_starts(std::istream& text, const std::string& name) {
  CsvReader reader(text, name, [](const std::string& what) { throw SceneError(what); });
  const auto header = reader.record();
  if (!header) throw SceneError(fmt::format("{}: holds no line of column names", name));
  const std::vector<std::size_t> columns = columns_of(reader, *header);
  std::vector<FiberStart> starts;
  while (const auto fields = reader.record()) starts.push_back(start_of(reader, columns, *fields));
  if (starts.empty()) throw SceneError(fmt::format("{}: holds no fiber", name));
  return starts;
}

std::vector<FiberStart> read_fiber_starts(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw SceneError(fmt::format("{}: cannot be opened", path));
  return read_fiber_starts(file, path);
}

std::size_t line_of_start(const std::string& text, std::size_t n) {
  std::istringstream lines(text);
  CsvReader reader(lines, "", [](const std::string& what) { throw SceneError(what); });
  for (std::size_t record = 0; reader.record(); ++record) {
    if (record == n + 1) return reader.line_number();
  }
  return 0;
}

}  // namespace fiberchain::dem
