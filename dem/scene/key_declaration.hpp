#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dem/math/vec.hpp"
#include "dem/scene/value_range.hpp"

namespace fiberchain::dem {

/// Declaration of one key of a scene file: reader, error texts and the reference page come from it.
struct KeyDeclaration {
  std::string name;
  std::string unit;       ///< SI unit; "1": a number without dimension; "": no number
  std::string allowed;    ///< in words
  std::string otherwise;  ///< value where the key is left out, in words; empty where that must not be
  std::string meaning;    ///< one sentence, Markdown
  bool must = false;      ///< the key must be there
  bool list = false;      ///< a list of mappings with `keys`
  bool file = false;      ///< names a file whose content counts, not its name
  std::vector<KeyDeclaration> keys = {};  ///< of the nested mapping
};

/// The text that a scene file would have for a value.
inline std::string scene_text(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }
inline std::string scene_text(int value) { return fmt::format("{}", value); }
inline std::string scene_text(std::int64_t value) { return fmt::format("{}", value); }
inline std::string scene_text(std::uint64_t value) { return fmt::format("{}", value); }
inline std::string scene_text(bool value) { return value ? "true" : "false"; }
inline std::string scene_text(const std::string& value) { return value; }
inline std::string scene_text(const std::array<double, 3>& v) {
  return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]);
}
inline std::string scene_text(const Vec<double, 3>& v) {
  return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]);
}
template <class Value>
std::string scene_text(const std::optional<Value>& value) {
  return value ? scene_text(*value) : "";
}

}  // namespace fiberchain::dem
