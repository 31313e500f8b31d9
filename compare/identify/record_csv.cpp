#include "compare/identify/record_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "compare/study/errors.hpp"
#include "dem/files/csv_reader.hpp"
#include "dem/files/numbers.hpp"

namespace fiberchain::compare {
namespace {

using Fields = std::vector<std::string>;

std::size_t column_of(const dem::CsvReader& reader, const Fields& header, const std::string& name) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (dem::trimmed(header[i]) == name) return i;
  }
  reader.fail(fmt::format("there is no column '{}'; there are: {}", name, fmt::join(header, ", ")));
}

double number_in(const dem::CsvReader& reader, const Fields& fields, std::size_t column) {
  if (column >= fields.size()) reader.fail(fmt::format("column {} is missing", column + 1));
  const auto number = dem::parse_number(dem::trimmed(fields[column]));
  if (!number || !std::isfinite(*number))
    reader.fail(
        fmt::format("column {}: '{}' is not a finite number", column + 1, dem::trimmed(fields[column])));
  return *number;
}

}  // namespace

RingDownRecord read_record(std::istream& input, const std::string& name, const RecordColumns& columns) {
  dem::CsvReader reader(input, name, [](const std::string& text) { throw InputError(text); });
  const auto header = reader.record();
  if (!header) reader.fail("holds no header");
  if (dem::parse_number(dem::trimmed(header->front())))
    reader.fail("begins with a number; allowed: a header with the names of the columns");
  if (header->size() < 2) reader.fail("has one column; needed: times and displacements");
  const std::size_t time = columns.time.empty() ? 0 : column_of(reader, *header, columns.time),
                    displacement = columns.displacement.empty()
                                       ? (time == 1 ? 0 : 1)
                                       : column_of(reader, *header, columns.displacement);
  RingDownRecord record;
  while (const auto fields = reader.record()) {
    record.time.push_back(columns.time_unit * number_in(reader, *fields, time));
    record.displacement.push_back(number_in(reader, *fields, displacement));
    const std::size_t n = record.time.size();
    if (n > 1 && !(record.time[n - 1] > record.time[n - 2])) reader.fail("times must rise");
  }
  return record;
}

RingDownRecord read_record(const std::filesystem::path& path, const RecordColumns& columns) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(fmt::format("{}: there is no such file, or it cannot be read", path.string()));
  return read_record(file, path.string(), columns);
}

}  // namespace fiberchain::compare
