#include "dem/record/csv.hpp"

#include <fmt/format.h>

#include <fstream>
#include <utility>

#include "dem/files/csv_reader.hpp"
#include "dem/files/numbers.hpp"
#include "dem/record/columns.hpp"
#include "dem/record/errors.hpp"

namespace fiberchain::dem {
namespace {

std::string field(const Cell& cell, CellKind kind) {
  if (const auto* text = std::get_if<std::string>(&cell)) return csv_field(*text);
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
  return kind == CellKind::text ? "" : "nan";
}

Cell parsed(const std::string& text, const Column& column, const CsvReader& reader) {
  if (column.kind == CellKind::text) return text;
  if (text == "nan") return Missing{};
  if (column.kind == CellKind::integer) {
    if (const auto value = parse_integer(text)) return *value;
  } else if (const auto value = parse_number(text)) {
    return *value;
  }
  reader.fail(fmt::format("column {}: '{}' is no {}", column.name, text, to_string(column.kind)));
}

std::pair<std::string, std::string> comment(const std::string& line) {
  const auto begin = line.find_first_not_of("# ");
  const auto colon = line.find(": ");
  if (begin == std::string::npos || colon == std::string::npos || colon < begin) return {"", line};
  return {line.substr(begin, colon - begin), line.substr(colon + 2)};
}

Table header(const CsvReader& reader, std::vector<std::string> columns) {
  try {
    return Table(std::move(columns));
  } catch (const TableError& error) {
    reader.fail(error.what());
  }
}

}  // namespace

std::string csv_field(const std::string& text) {
  const bool plain = text.find_first_of(",\"\r\n") == std::string::npos && !text.starts_with('#');
  if (plain) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::vector<std::pair<std::string, std::string>> csv_comments(const CsvReader& reader) {
  std::vector<std::pair<std::string, std::string>> comments;
  for (const std::string& line : reader.comments()) comments.push_back(comment(line));
  return comments;
}

std::string to_csv(const Table& table, const Provenance& provenance) {
  std::string text;
  for (const auto& [key, value] : entries(provenance)) text += fmt::format("# {}: {}\n", key, value);
  text += fmt::format("{}\n", fmt::join(table.columns(), ","));
  for (const auto& row : table.rows()) {
    std::vector<std::string> fields;
    for (std::size_t i = 0; i < row.size(); ++i) {
      fields.push_back(field(row[i], find_column(table.columns()[i]).kind));
    }
    text += fmt::format("{}\n", fmt::join(fields, ","));
  }
  return text;
}

CsvDocument read_csv(std::istream& input, const std::string& name) {
  CsvReader reader(input, name, [](const std::string& what) { throw InputError(what); });
  auto fields = reader.record();
  if (!fields) reader.fail("no header: the file holds no table");
  CsvDocument document{csv_comments(reader), header(reader, *fields), {}};
  const std::vector<std::string> columns = document.table.columns();
  while ((fields = reader.record())) {
    if (fields->size() != columns.size()) {
      reader.fail(fmt::format("{} fields where the header has {}", fields->size(), columns.size()));
    }
    NamedRow row;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      row.emplace_back(columns[i], parsed((*fields)[i], find_column(columns[i]), reader));
    }
    document.table.append(row);
    document.lines.push_back(reader.line_number());
  }
  return document;
}

CsvDocument read_csv(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(path.string() + ": cannot read this file");
  return read_csv(file, path.string());
}

}  // namespace fiberchain::dem
