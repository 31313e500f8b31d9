#include "dem/scene/fiber_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "dem/scene/yaml_document.hpp"
#include "dem/files/numbers.hpp"
#include "dem/scene/scene_error.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::array<std::string_view, 9> names{"x", "y", "z", "ux", "uy", "uz", "vx", "vy", "vz"};
constexpr std::size_t required = 6;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first, last - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    fields.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  return fields;
}

class Reader {
 public:
  Reader(std::istream& text, const std::string& name) : text_(text), name_(name) {}

  /// The next line that says something; false at the end.
  bool next() {
    while (std::getline(text_, line_)) {
      ++number_;
      if (number_ == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);
      const std::string_view text = trimmed(line_);
      if (!text.empty() && text.front() != '#') return true;
    }
    if (text_.bad()) fail("cannot be read");
    return false;
  }

  void read_header() {
    if (!next()) throw SceneError(fmt::format("{}: holds no line of column names", name_));
    for (const std::string_view field : fields_of(line_)) {
      const auto found = std::ranges::find(names, field);
      if (found == names.end()) {
        fail(fmt::format(
            "column '{}' is unknown; columns are x, y, z, ux, uy, uz and, if fibers move, vx, vy, vz",
            printable(field)));
      }
      const auto column = static_cast<std::size_t>(found - names.begin());
      if (std::ranges::find(columns_, column) != columns_.end())
        fail(fmt::format("column '{}' stands twice", field));
      columns_.push_back(column);
    }
    const bool moves = std::ranges::any_of(columns_, [](std::size_t c) { return c >= required; });
    for (std::size_t c = 0; c < (moves ? names.size() : required); ++c) {
      if (std::ranges::find(columns_, c) == columns_.end())
        fail(fmt::format("column '{}' is missing", names[c]));
    }
  }

  FiberStart read_start() const {
    const auto fields = fields_of(line_);
    if (fields.size() != columns_.size()) {
      fail(fmt::format("has {} fields; allowed: {}, as many as columns", fields.size(), columns_.size()));
    }
    std::array<double, names.size()> value{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto number = parse_number(fields[i]);
      if (!number || !std::isfinite(*number)) {
        fail(fmt::format("column '{}': '{}' is not allowed; allowed: a number that is finite",
                         names[columns_[i]], printable(fields[i])));
      }
      value[columns_[i]] = *number;
    }
    const FiberStart start{
        {value[0], value[1], value[2]}, {value[3], value[4], value[5]}, {value[6], value[7], value[8]}};
    const double length = norm(start.direction);
    if (!(std::abs(length - 1) < 1e-3)) {
      fail(fmt::format("columns 'ux', 'uy', 'uz': the direction's length is {:.6g}; allowed: 1", length));
    }
    return start;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw SceneError(fmt::format("{}:{}: {}", name_, number_, what));
  }

  std::istream& text_;
  std::string name_, line_;
  std::int64_t number_ = 0;
  std::vector<std::size_t> columns_;
};

}  // namespace

std::vector<FiberStart> read_fiber_starts(std::istream& text, const std::string& name) {
  Reader reader(text, name);
  reader.read_header();
  std::vector<FiberStart> starts;
  while (reader.next()) starts.push_back(reader.read_start());
  if (starts.empty()) throw SceneError(fmt::format("{}: holds no fiber", name));
  return starts;
}

std::vector<FiberStart> read_fiber_starts(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw SceneError(fmt::format("{}: cannot be opened", path));
  return read_fiber_starts(file, path);
}

}  // namespace fiberchain::dem
