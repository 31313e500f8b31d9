#include "dem/scene/strict_mapping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "dem/files/nearest_word.hpp"
#include "dem/files/numbers.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/scene/scene_settings.hpp"
#include "dem/scene/yaml_document.hpp"

namespace fiberchain::dem {
namespace {

/// Three finite numbers; nothing if the node is anything else.
std::optional<std::array<double, 3>> three_numbers(const YAML::Node& node) {
  if (!node.IsSequence() || node.size() != 3) return std::nullopt;
  std::array<double, 3> components{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = node[i].IsScalar() ? parse_number(node[i].Scalar()) : std::nullopt;
    if (!number || !std::isfinite(*number)) return std::nullopt;
    components[i] = *number;
  }
  return components;
}

}  // namespace

StrictMapping::StrictMapping(const std::string& text, std::string name, std::shared_ptr<const Units> units)
    : StrictMapping(read_document(text, name), name, std::move(units)) {}

StrictMapping::StrictMapping(const SceneText& scene, std::shared_ptr<const Units> units)
    : StrictMapping(settled_document(scene), scene.name, std::move(units)) {}

StrictMapping::StrictMapping(const YAML::Node& top, std::string name, std::shared_ptr<const Units> units)
    : node_(top), mark_(node_.Mark()), name_(std::move(name)), units_(std::move(units)) {
  if (!node_.IsMap()) fail("", "must be a mapping of keys and values");
  if (units_) return;
  try {
    units_ = std::make_shared<const Units>();
  } catch (const UnitError& error) {
    throw SceneError(error.what());
  }
}

StrictMapping::StrictMapping(const StrictMapping& parent, const std::string& key)
    : node_(parent.value(key)),
      mark_(parent.mark_of(key)),
      path_(parent.path_ + key + "."),
      name_(parent.name_),
      units_(parent.units_) {}

StrictMapping::StrictMapping(const StrictMapping& parent, const YAML::Node& node, const std::string& path)
    : node_(node), mark_(node.Mark()), path_(path), name_(parent.name_), units_(parent.units_) {}

void StrictMapping::allow(const std::vector<std::string>& keys) const {
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    const YAML::Mark mark = entry.first.Mark();
    if (!entry.first.IsScalar()) fail_at(mark, "a key must be a word");
    const std::string& key = entry.first.Scalar();
    if (!std::ranges::count(keys, key)) {
      fail_at(mark, fmt::format("unknown key '{}{}'; {}", path_, printable(key), suggestion(key, keys)));
    }
    if (!seen.insert(key).second) fail_at(mark, fmt::format("key '{}{}' comes twice", path_, key));
  }
}

StrictMapping StrictMapping::mapping(const std::string& key, const std::vector<std::string>& keys) const {
  if (!value(key).IsMap()) fail(key, fmt::format("must be a mapping with keys of {}", fmt::join(keys, ", ")));
  const StrictMapping found(*this, key);
  found.allow(keys);
  return found;
}

std::vector<StrictMapping> StrictMapping::mappings(const std::string& key,
                                                   const std::vector<std::string>& keys) const {
  const YAML::Node list = value(key);
  const std::string what = fmt::format("must be a list of mappings with keys of {}", fmt::join(keys, ", "));
  if (!list.IsSequence() || list.size() == 0) fail(key, what);
  std::vector<StrictMapping> found;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const StrictMapping one(*this, list[i], fmt::format("{}{}[{}].", path_, key, i));
    if (!one.node_.IsMap()) one.fail("", what);
    one.allow(keys);
    found.push_back(one);
  }
  return found;
}

double StrictMapping::to_si(const std::string& key, const std::string& typed, std::string_view unit) const {
  try {
    return units_->to_si(typed, unit);
  } catch (const UnitError& error) {
    fail(key, fmt::format("'{}' {}", printable(typed), error.what()));
  }
}

std::vector<double> StrictMapping::quantities(const std::string& key, std::string_view unit,
                                              std::size_t count, const ValueRange& allowed) const {
  const YAML::Node list = value(key);
  const std::string what = fmt::format("must be a list of {} finite numbers{}", count,
                                       unit == "1" ? "" : fmt::format(" in {}", unit));
  if (!list.IsSequence() || list.size() != count) fail(key, what);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    if (!list[i].IsScalar()) fail(key, what);
    numbers.push_back(to_si(key, list[i].Scalar(), unit));
    if (!std::isfinite(numbers.back())) fail(key, what);
    if (!allowed.holds(numbers.back())) {
      fail(key, fmt::format("'{}' is out of range; allowed: numbers {}{}", printable(list[i].Scalar()),
                            describe(allowed), unit == "1" ? "" : fmt::format(", in {}", unit)));
    }
  }
  return numbers;
}

std::vector<std::string> StrictMapping::words(const std::string& key, std::size_t count) const {
  const YAML::Node list = value(key);
  std::vector<std::string> all;
  if (list.IsSequence()) {
    for (const auto& entry : list) {
      if (entry.IsScalar() && !entry.Scalar().empty()) all.push_back(entry.Scalar());
    }
  }
  if (!list.IsSequence() || list.size() != count || all.size() != count)
    fail(key, fmt::format("must be a list of {} words", count));
  return all;
}

double StrictMapping::quantity(const std::string& key, std::string_view unit,
                               const ValueRange& allowed) const {
  const std::string typed = text(key);
  const double number = to_si(key, typed, unit);
  if (!allowed.holds(number)) {
    fail(key, fmt::format("'{}' is out of range; allowed: a number {}{}", printable(typed), describe(allowed),
                          unit == "1" ? "" : fmt::format(", in {}", unit)));
  }
  return number;
}

int StrictMapping::integer(const std::string& key, const ValueRange& allowed) const {
  const std::string typed = text(key);
  const auto number = parse_integer(typed);
  const bool fits =
      number && *number >= std::numeric_limits<int>::min() && *number <= std::numeric_limits<int>::max();
  if (!fits || !allowed.holds(static_cast<double>(*number))) {
    ValueRange shown = allowed;
    if (number && !fits) shown.high = std::min<double>(shown.high, std::numeric_limits<int>::max());
    fail(key,
         fmt::format("'{}' is not allowed; allowed: a whole number {}", printable(typed), describe(shown)));
  }
  return static_cast<int>(*number);
}

std::size_t StrictMapping::choice(const std::string& key, const std::vector<std::string>& words) const {
  const std::string typed = text(key);
  const auto found = std::ranges::find(words, typed);
  if (found == words.end()) {
    fail(key, fmt::format("'{}' is not allowed; allowed: {}", printable(typed), fmt::join(words, ", ")));
  }
  return static_cast<std::size_t>(found - words.begin());
}

std::array<double, 3> StrictMapping::direction(const std::string& key) const {
  auto direction = three_numbers(value(key));
  if (!direction) fail(key, "must be three finite numbers such as [0, 1, 0]");
  double largest = 0;
  for (const double component : *direction) largest = std::max(largest, std::abs(component));
  if (!(largest > 0)) fail(key, "must not be zero");
  for (double& component : *direction) component /= largest;  // squares of what is typed may be no numbers
  const double length = std::hypot((*direction)[0], (*direction)[1], (*direction)[2]);
  for (double& component : *direction) component /= length;
  return *direction;
}

std::array<std::array<double, 3>, 3> StrictMapping::matrix(const std::string& key,
                                                           const ValueRange& allowed) const {
  const YAML::Node node = value(key);
  std::array<std::array<double, 3>, 3> rows{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = node.IsSequence() && node.size() == 3 ? three_numbers(node[i]) : std::nullopt;
    if (!row)
      fail(key, "must be three rows of three finite numbers such as [[0, 1, 0], [0, 0, 0], [0, 0, 0]]");
    for (const double number : *row) {
      if (!allowed.holds(number))
        fail(key, fmt::format("'{}' is out of range; allowed: numbers {}", number, describe(allowed)));
    }
    rows[i] = *row;
  }
  return rows;
}

std::string StrictMapping::one_of(const std::vector<std::string>& keys) const {
  std::vector<std::string> given;
  std::ranges::copy_if(keys, std::back_inserter(given), [&](const std::string& key) { return has(key); });
  if (given.size() != 1) fail("", fmt::format("must have exactly one of {}", fmt::join(keys, ", ")));
  return given.front();
}

bool StrictMapping::is_word(const std::string& key, const std::string& word) const {
  const YAML::Node node = node_[key];
  return node && node.IsScalar() && node.Scalar() == word;
}

void StrictMapping::fail(const std::string& key, const std::string& message) const {
  std::string path = path_ + key;
  if (path.ends_with('.')) path.pop_back();
  fail_at(mark_of(key), path.empty() ? message : fmt::format("{}: {}", path, message));
}

void StrictMapping::fail_within(const std::string& keys, const std::string& message) const {
  struct Search {
    const std::string& keys;
    std::optional<YAML::Mark> mark = {};
    std::string found = {};

    void look_in(const YAML::Node& node, const std::string& path) {
      if (node.IsSequence()) {
        for (std::size_t i = 0; i < node.size() && !mark; ++i)
          look_in(node[i], fmt::format("{}[{}]", path, i));
      }
      if (!node.IsMap()) return;
      for (const auto& entry : node) {
        if (mark || !entry.first.IsScalar()) return;
        const std::string own = path.empty() ? entry.first.Scalar() : path + "." + entry.first.Scalar();
        if (own == keys || own.ends_with("." + keys)) {
          mark = entry.first.Mark(), found = own;
          return;
        }
        look_in(entry.second, own);
      }
    }
  };
  Search search{keys};
  search.look_in(node_, "");
  if (search.mark) fail_at(*search.mark, fmt::format("{}{}: {}", path_, search.found, message));
  fail("", message);
}

void StrictMapping::fail_missing(const std::string& key) const {
  fail("", fmt::format("key '{}' is missing", key));
}

YAML::Mark StrictMapping::mark_of(const std::string& key) const {
  if (!node_.IsMap()) return mark_;
  for (const auto& entry : node_) {
    if (entry.first.IsScalar() && entry.first.Scalar() == key) return entry.first.Mark();
  }
  return mark_;
}

void StrictMapping::fail_at(const YAML::Mark& mark, const std::string& message) const {
  if (mark.is_null()) throw SceneError(fmt::format("{}: {}", name_, message));  // a setting's, in no line
  throw SceneError(fmt::format("{}:{}: {}", name_, mark.line + 1, message));
}

YAML::Node StrictMapping::value(const std::string& key) const {
  if (!has(key)) fail_missing(key);
  return node_[key];
}

std::string StrictMapping::text(const std::string& key) const {
  const YAML::Node node = value(key);
  if (!node.IsScalar() || node.Scalar().empty()) fail(key, "must be a single value");
  return node.Scalar();
}

}  // namespace fiberchain::dem
