#include "dem/record/csv.hpp"

#include <fmt/format.h>

#include <fstream>
#include <istream>
#include <optional>

#include "dem/record/errors.hpp"
#include "dem/record/columns.hpp"
#include "dem/files/numbers.hpp"

namespace fiberchain::dem {
namespace {

std::string quoted_field(const std::string& text) {
  const bool plain = text.find_first_of(",\"\r\n") == std::string::npos && !text.starts_with('#');
  if (plain) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string field(const Cell& cell, CellKind kind) {
  if (const auto* text = std::get_if<std::string>(&cell)) return quoted_field(*text);
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
  return kind == CellKind::text ? "" : "nan";
}

/// Reads records of a CSV text and counts its lines.
class Reader {
 public:
  Reader(std::istream& input, std::string name) : input_(input), name_(std::move(name)) {}

  /// The next line that is not a record's continuation, without its end; nothing at the end of the file.
  std::optional<std::string> line() {
    std::string text;
    if (!std::getline(input_, text)) return std::nullopt;
    ++line_;
    if (text.ends_with('\r')) text.pop_back();
    return text;
  }

  /// Splits a record that begins with this line, reading on where a quoted field spans lines.
  std::vector<std::string> split(std::string text) {
    std::vector<std::string> fields;
    std::size_t at = 0;
    do {
      fields.push_back(at < text.size() && text[at] == '"' ? quoted(text, at) : plain(text, at));
    } while (at++ < text.size());
    return fields;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", name_, line_, what));
  }

  std::size_t line_number() const { return line_; }

 private:
  std::string plain(const std::string& text, std::size_t& at) const {
    const std::size_t begin = at;
    at = std::min(text.find(',', at), text.size());
    return text.substr(begin, at - begin);
  }

  std::string quoted(std::string& text, std::size_t& at) {
    std::string value;
    for (++at;; ++at) {
      if (at == text.size()) {
        const auto more = line();
        if (!more) fail("a quoted field is not closed");
        text += '\n' + *more;
      }
      if (text[at] == '"' && (++at == text.size() || text[at] != '"')) break;
      value += text[at];
    }
    if (at < text.size() && text[at] != ',') fail("text after a quoted field");
    return value;
  }

  std::istream& input_;
  std::string name_;
  std::size_t line_ = 0;
};

Cell parsed(const std::string& text, const Column& column, const Reader& reader) {
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

Table header(Reader& reader, const std::string& line) {
  try {
    return Table(reader.split(line));
  } catch (const TableError& error) {
    reader.fail(error.what());
  }
}

}  // namespace

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
  Reader reader(input, name);
  std::vector<std::pair<std::string, std::string>> comments;
  auto line = reader.line();
  for (; line && (line->empty() || line->starts_with('#')); line = reader.line()) {
    if (!line->empty()) comments.push_back(comment(*line));
  }
  if (!line) reader.fail("no header: the file holds no table");
  CsvDocument document{std::move(comments), header(reader, *line), {}};
  const std::vector<std::string> columns = document.table.columns();
  while ((line = reader.line())) {
    if (line->empty() || line->starts_with('#')) continue;
    const std::size_t number = reader.line_number();
    const auto fields = reader.split(*line);
    if (fields.size() != columns.size()) {
      reader.fail(fmt::format("{} fields where the header has {}", fields.size(), columns.size()));
    }
    NamedRow row;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      row.emplace_back(columns[i], parsed(fields[i], find_column(columns[i]), reader));
    }
    document.table.append(row);
    document.lines.push_back(number);
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
