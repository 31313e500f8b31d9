#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dem/scene/scene_text.hpp"
#include "dem/scene/units.hpp"
#include "dem/scene/value_range.hpp"

namespace fiberchain::dem {

/// One mapping of a scene file, read strictly: every key it holds must be known, every key asked for must
/// be there and right. All functions throw SceneError.
class StrictMapping {
 public:
  /// The top of the YAML text; `name` is what messages call the file. No key is checked yet.
  /// `units`: those of another reader, which take some 10 ms to load; loaded where null.
  StrictMapping(const std::string& text, std::string name, std::shared_ptr<const Units> units = nullptr);
  /// The same of a scene with its settings.
  explicit StrictMapping(const SceneText& scene, std::shared_ptr<const Units> units = nullptr);

  /// Refuses a key that is not among these, or that comes twice; names the nearest known one.
  void allow(const std::vector<std::string>& keys) const;

  bool has(const std::string& key) const { return static_cast<bool>(node_[key]); }

  /// The mapping under this key, only `keys` allowed in it.
  StrictMapping mapping(const std::string& key, const std::vector<std::string>& keys) const;

  /// The same of a mapping whose keys have been checked.
  StrictMapping mapping(const std::string& key) const { return {*this, key}; }

  /// The mappings of the sequence under this key, at least one, only `keys` allowed in each.
  std::vector<StrictMapping> mappings(const std::string& key, const std::vector<std::string>& keys) const;

  /// A number, alone or with a unit, in the SI unit `unit`.
  double quantity(const std::string& key, std::string_view unit, const ValueRange& allowed) const;

  /// A number without dimension.
  double number(const std::string& key, const ValueRange& allowed) const {
    return quantity(key, "1", allowed);
  }

  /// So many numbers, each alone or with a unit.
  std::vector<double> quantities(const std::string& key, std::string_view unit, std::size_t count,
                                 const ValueRange& allowed = kFinite) const;

  int integer(const std::string& key, const ValueRange& allowed) const;

  /// One of the words; its index among them.
  std::size_t choice(const std::string& key, const std::vector<std::string>& words) const;

  /// A text that is not empty.
  std::string word(const std::string& key) const { return text(key); }

  /// So many texts that are not empty.
  std::vector<std::string> words(const std::string& key, std::size_t count) const;

  /// true or false.
  bool flag(const std::string& key) const { return choice(key, {"false", "true"}) == 1; }

  /// Unit vector along three finite numbers that are not all zero.
  std::array<double, 3> direction(const std::string& key) const;

  /// Three rows of three numbers.
  std::array<std::array<double, 3>, 3> matrix(const std::string& key,
                                              const ValueRange& allowed = kFinite) const;

  /// Exactly one of these keys must be there; its name.
  std::string one_of(const std::vector<std::string>& keys) const;

  /// Whether the key holds this word.
  bool is_word(const std::string& key, const std::string& word) const;

  /// For another reader.
  const std::shared_ptr<const Units>& units() const { return units_; }

  /// What messages call the file.
  const std::string& file() const { return name_; }

  /// A SceneError about a key of this mapping ("" for the mapping itself).
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

  /// A SceneError about the first key of this mapping and of those in it whose path ends in these,
  /// "motion.step", "fibers[0].density"; about the mapping itself where there is none.
  [[noreturn]] void fail_within(const std::string& keys, const std::string& message) const;

  /// A SceneError for a key that is not there but must be.
  [[noreturn]] void fail_missing(const std::string& key) const;

 private:
  StrictMapping(const YAML::Node& top, std::string name, std::shared_ptr<const Units> units);
  StrictMapping(const StrictMapping& parent, const std::string& key);
  StrictMapping(const StrictMapping& parent, const YAML::Node& node, const std::string& path);
  double to_si(const std::string& key, const std::string& typed, std::string_view unit) const;
  std::string text(const std::string& key) const;
  YAML::Node value(const std::string& key) const;
  YAML::Mark mark_of(const std::string& key) const;  ///< of the key; of the mapping where the key is absent
  [[noreturn]] void fail_at(const YAML::Mark& mark, const std::string& message) const;

  YAML::Node node_;
  YAML::Mark mark_;   ///< where the mapping begins: its key
  std::string path_;  ///< keys that lead here, each with a dot behind it
  std::string name_;
  std::shared_ptr<const Units> units_;
};

}  // namespace fiberchain::dem
