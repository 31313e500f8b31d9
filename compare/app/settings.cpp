#include "compare/app/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compare/study/errors.hpp"
#include "compare/study/ranges.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/scene_settings.hpp"

namespace fiberchain::app {
namespace {

constexpr std::size_t most_runs = 10000;

[[noreturn]] void refuse_set(const std::string& typed, const std::string& reason) {
  throw compare::InputError(fmt::format("--set: '{}' {}", typed, reason));
}

/// At commas that are not within brackets or quotes.
std::vector<std::string> split_values(const std::string& typed, const std::string& text) {
  std::vector<std::string> values(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      values.emplace_back();
      continue;
    }
    values.back() += c;
  }
  if (depth != 0 || quote != 0) refuse_set(typed, "has a bracket or a quote that does not close");
  if (std::ranges::any_of(values, &std::string::empty)) refuse_set(typed, "has an empty value");
  return values;
}

/// "1..3", not a path such as "../fill.h5".
bool is_range(const std::string& value) {
  const std::size_t dots = value.find("..");
  return dots != std::string::npos && dots > 0 &&
         std::isdigit(static_cast<unsigned char>(value[dots - 1])) != 0 &&
         value.find_first_not_of("0123456789.+-eE:linog") == std::string::npos;
}

SweptKey swept_key(const std::string& typed) {
  const std::size_t equals = typed.find('=');
  if (equals == std::string::npos || equals == 0)
    refuse_set(typed, "is no KEY=VALUE, such as contacts.friction=0.2 or filling.seed=1..3");
  SweptKey key{typed.substr(0, equals), {}};
  for (const std::string& value : split_values(typed, typed.substr(equals + 1))) {
    if (!is_range(value)) {
      key.values.push_back(value);
      continue;
    }
    for (const double number : compare::parse_numbers("--set " + key.key, value, {}))
      key.values.push_back(fmt::format("{}", number));
  }
  return key;
}

}  // namespace

Option set_option() {
  return {
      "--set", "KEY=VALUES",
      "a key of the scene by its path, in place of what the file says; with several values (0.2,0.4 or 1..3) "
      "every combination is run; may be given several times",
      OptionKind::several};
}

std::vector<SweptKey> swept_keys(const Arguments& arguments) {
  std::vector<SweptKey> keys;
  std::size_t runs = 1;
  for (const std::string& typed : arguments.texts("--set")) {
    SweptKey key = swept_key(typed);
    if (std::ranges::find(keys, key.key, &SweptKey::key) != keys.end())
      refuse_set(typed, fmt::format("sets {} a second time; give all its values at once", key.key));
    runs *= key.values.size();
    if (runs > most_runs) refuse_set(typed, fmt::format("makes more than {} runs", most_runs));
    keys.push_back(std::move(key));
  }
  return keys;
}

std::vector<std::vector<dem::SceneSetting>> combinations(const std::vector<SweptKey>& keys) {
  std::vector<std::vector<dem::SceneSetting>> all(1);
  for (const SweptKey& key : keys) {
    std::vector<std::vector<dem::SceneSetting>> longer;
    for (const auto& one : all) {
      for (const std::string& value : key.values) {
        longer.push_back(one);
        longer.back().push_back({key.key, value});
      }
    }
    all = std::move(longer);
  }
  return all;
}

dem::SceneText with_settings(dem::SceneText scene, const std::vector<dem::SceneSetting>& settings) {
  if (settings.empty()) return scene;
  dem::parse_scene(scene);  // what is wrong without them is the scene's own fault
  scene.settings = settings;
  try {
    dem::parse_scene(scene);
  } catch (const dem::SceneError& error) {
    throw compare::InputError(fmt::format("--set {}: {}", in_words(settings), error.what()));
  }
  return scene;
}

}  // namespace fiberchain::app
