#pragma once

#include <cstddef>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace fiberchain::dem {

/// Records of a CSV text (RFC 4180: quoted fields may hold commas, quotes and line ends), with the number of
/// their line. A byte order mark and carriage returns are passed over.
class CsvReader {
 public:
  /// Called with "NAME:LINE: what is wrong"; must throw.
  using Fail = std::function<void(const std::string&)>;

  CsvReader(std::istream& input, std::string name, Fail fail)
      : input_(input), name_(std::move(name)), fail_(std::move(fail)) {}

  /// Fields of the next record; nothing at the end. Blank lines and comments are passed over, comments kept.
  std::optional<std::vector<std::string>> record();

  /// Lines that began with '#', as they stand.
  const std::vector<std::string>& comments() const { return comments_; }
  /// Of the record read last, 1 for the first line.
  std::size_t line_number() const { return record_line_; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::optional<std::string> line();
  std::string plain_field(const std::string& text, std::size_t& at) const;
  std::string quoted_field(std::string& text, std::size_t& at);

  std::istream& input_;
  std::string name_;
  Fail fail_;
  std::size_t line_ = 0, record_line_ = 0;
  std::vector<std::string> comments_;
};

/// Without spaces and tabs at either end.
std::string_view trimmed(std::string_view text);

}  // namespace fiberchain::dem
