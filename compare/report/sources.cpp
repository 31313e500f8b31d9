#include "compare/report/sources.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

namespace fs = std::filesystem;

SourceFile file_in(const SourceDirectory& directory, const fs::path& path) {
  return {path, directory.label + "/" + path.filename().string()};
}

struct OriginField {
  const char* key;
  std::string Origin::*field;
};

constexpr std::array<OriginField, 4> kOriginFields = {{{"version", &Origin::version},
                                                       {"commit", &Origin::commit},
                                                       {"date", &Origin::date},
                                                       {"command", &Origin::command}}};

/// What stands between a mark and the next line's end, or the next chunk of a PNG, whose four bytes of length
/// and checksum are no text; "" without the mark.
std::string value_after(const std::string& content, const std::string& mark, std::size_t most) {
  const std::size_t found = content.find(mark);
  if (found == std::string::npos) return "";
  const std::size_t begin = found + mark.size();
  const std::size_t end = std::min(content.find('\n', begin), std::min(content.size(), begin + most));
  return content.substr(begin, end - begin);
}

/// Length of the tEXt chunk's text behind `mark`: its four bytes stand before "tEXt".
std::size_t chunk_text_length(const std::string& png, const std::string& mark) {
  const std::size_t found = png.find(mark);
  if (found == std::string::npos || found < 4) return 0;
  std::size_t length = 0;
  for (std::size_t i = found - 4; i < found; ++i) length = length * 256 + static_cast<unsigned char>(png[i]);
  const std::size_t key = mark.size() - 4;
  return length < key ? 0 : length - key;
}

/// Entities of XML taken back.
std::string unescaped(std::string text) {
  for (const auto& [entity, letter] : std::array<std::pair<std::string, std::string>, 5>{
           {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}}) {
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; at += letter.size())
      text.replace(at, entity.size(), letter);
  }
  return text;
}

}  // namespace

std::optional<SourceFile> find_source(const Sources& sources, const std::string& name) {
  for (const SourceDirectory& directory : sources) {
    const fs::path path = directory.path / name;
    if (fs::is_regular_file(path)) return file_in(directory, path);
  }
  return std::nullopt;
}

std::vector<SourceFile> find_trajectories(const Sources& sources) {
  for (const SourceDirectory& directory : sources) {
    std::vector<SourceFile> found;
    std::error_code unreadable;
    for (const auto& entry : fs::directory_iterator(directory.path, unreadable))
      if (entry.path().extension() == ".h5") found.push_back(file_in(directory, entry.path()));
    std::ranges::sort(found, {}, &SourceFile::path);
    if (!found.empty()) return found;
  }
  return {};
}

std::string read_source(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw InputError(path.string() + ": cannot be read");
  return content;
}

Origin origin_of(const std::string& label, const std::string& content) {
  Origin origin{.file = label, .version = {}, .commit = {}, .date = {}, .command = {}};
  const bool png = content.starts_with("\x89PNG");
  for (const auto& [key, field] : kOriginFields) {
    if (png) {
      const std::string mark = std::string("tEXtfiberchain:") + key + '\0';
      origin.*field = value_after(content, mark, chunk_text_length(content, mark));
    } else {
      const char* const begin = content.starts_with("#") ? "\n# " : "\n";
      origin.*field = unescaped(value_after(content, std::string(begin) + key + ": ", content.size()));
    }
  }
  return origin;
}

Origin origin_of(const std::string& label, const std::vector<std::pair<std::string, std::string>>& entries) {
  Origin origin{.file = label, .version = {}, .commit = {}, .date = {}, .command = {}};
  for (const auto& [key, value] : entries)
    for (const auto& [known, field] : kOriginFields)
      if (key == known) origin.*field = value;
  return origin;
}

}  // namespace fiberchain::compare
