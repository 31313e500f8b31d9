#include "dem/scene/wall_course_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "dem/files/csv_reader.hpp"
#include "dem/files/numbers.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/scene/yaml_document.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::array<std::string_view, 3> course_columns{"time", "place", "angle"};
/// Largest number in size that a course may hold.
constexpr double most_of_course = 1e9;

/// Index in course_columns of each field of the header.
std::vector<std::size_t> course_header(const CsvReader& reader, const std::vector<std::string>& header) {
  std::vector<std::size_t> columns;
  for (const std::string& text : header) {
    const std::string_view field = trimmed(text);
    const auto* const found = std::ranges::find(course_columns, field);
    if (found == course_columns.end()) {
      reader.fail(fmt::format("column '{}' is unknown; columns are time, place and angle", printable(field)));
    }
    const auto column = static_cast<std::size_t>(found - course_columns.begin());
    if (std::ranges::find(columns, column) != columns.end())
      reader.fail(fmt::format("column '{}' stands twice", field));
    columns.push_back(column);
  }
  if (std::ranges::find(columns, 0u) == columns.end()) reader.fail("column 'time' is missing");
  if (columns.size() < 2) reader.fail("columns 'place' and 'angle' are missing; allowed: one or both");
  return columns;
}

std::array<double, 3> course_line(const CsvReader& reader, const std::vector<std::size_t>& columns,
                                  const std::vector<std::string>& fields) {
  if (fields.size() != columns.size())
    reader.fail(fmt::format("has {} fields; allowed: {}, as many as columns", fields.size(), columns.size()));
  std::array<double, 3> value{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto number = parse_number(trimmed(fields[i]));
    if (!number || !(std::abs(*number) <= most_of_course)) {
      reader.fail(fmt::format("column '{}': '{}' is not allowed; allowed: a number of at most {:g} in size",
                              course_columns[columns[i]], printable(trimmed(fields[i])), most_of_course));
    }
    value[columns[i]] = *number;
  }
  return value;
}

}  // namespace

WallCourse read_wall_course(std::istream& text, const std::string& name) {
  CsvReader reader(text, name, [](const std::string& what) { throw SceneError(what); });
  const auto header = reader.record();
  if (!header) throw SceneError(fmt::format("{}: holds no line of column names", name));
  const std::vector<std::size_t> columns = course_header(reader, *header);
  std::vector<double> time, place, angle;
  while (const auto fields = reader.record()) {
    const std::array<double, 3> line = course_line(reader, columns, *fields);
    if (!time.empty() && !(line[0] - time.back() > 1e-12 * std::abs(line[0])))
      reader.fail(fmt::format("column 'time': {:g} is not allowed; allowed: later than the line before, {:g}",
                              line[0], time.back()));
    time.push_back(line[0]), place.push_back(line[1]), angle.push_back(line[2]);
  }
  if (time.size() < 2) throw SceneError(fmt::format("{}: holds fewer than two lines of a course", name));
  WallCourse course;
  course.place = monotone_cubic(time, std::move(place));
  course.angle = monotone_cubic(std::move(time), std::move(angle));
  return course;
}

}  // namespace fiberchain::dem
