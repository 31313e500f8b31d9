#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "dem/record/provenance.hpp"
#include "dem/record/table.hpp"

/// CSV as this program writes it: "# key: value" lines, a header, rows; RFC 4180 quoting, "nan" for a
/// missing number. Doubles have the fewest digits (17 at most) that read back to the same bits.
namespace fiberchain::dem {

/// The table as CSV under its provenance.
std::string to_csv(const Table& table, const Provenance& provenance);

/// A text as a field of CSV, quoted where it must be.
std::string csv_field(const std::string& text);

class CsvReader;

/// "# key: value" lines that a reader has passed, in order; without a key where a line is not such.
std::vector<std::pair<std::string, std::string>> csv_comments(const CsvReader& reader);

/// A table read back, with the entries of the comment lines.
struct CsvDocument {
  std::vector<std::pair<std::string, std::string>> comments;  ///< of "# key: value" lines, in order
  Table table;
  std::vector<std::size_t> lines;  ///< line number of each row
};

/// Reads CSV with columns of the dictionary. `name` is what error messages call it.
/// @throws InputError naming file, line and column of what cannot be read
CsvDocument read_csv(std::istream& input, const std::string& name);

/// The same from a file.
/// @throws InputError also if there is no such file
CsvDocument read_csv(const std::filesystem::path& path);

}  // namespace fiberchain::dem
