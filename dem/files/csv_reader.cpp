#include "dem/files/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace fiberchain::dem {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first, last - first + 1);
}

std::optional<std::vector<std::string>> CsvReader::record() {
  for (auto text = line(); text; text = line()) {
    const std::string_view content = trimmed(*text);
    if (content.starts_with('#')) comments_.push_back(*text);
    if (content.empty() || content.starts_with('#')) continue;
    record_line_ = line_;
    std::vector<std::string> fields;
    std::size_t at = 0;
    do {
      fields.push_back(at < text->size() && (*text)[at] == '"' ? quoted_field(*text, at)
                                                               : plain_field(*text, at));
    } while (at++ < text->size());
    return fields;
  }
  if (input_.bad()) fail("cannot be read");
  return std::nullopt;
}

void CsvReader::fail(const std::string& what) const {
  fail_(fmt::format("{}:{}: {}", name_, line_, what));
  throw std::logic_error("CsvReader::Fail must throw");
}

/// The next line without its end; nothing at the end of the file.
std::optional<std::string> CsvReader::line() {
  std::string text;
  if (!std::getline(input_, text)) return std::nullopt;
  ++line_;
  if (line_ == 1 && text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.ends_with('\r')) text.pop_back();
  return text;
}

std::string CsvReader::plain_field(const std::string& text, std::size_t& at) const {
  const std::size_t begin = at;
  at = std::min(text.find(',', at), text.size());
  return text.substr(begin, at - begin);
}

/// A quoted field, which may go on over several lines.
std::string CsvReader::quoted_field(std::string& text, std::size_t& at) {
  std::string value;
  for (++at;; ++at) {
    while (at == text.size()) {
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

}  // namespace fiberchain::dem
