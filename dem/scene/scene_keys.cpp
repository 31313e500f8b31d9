#include "dem/scene/scene_keys.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "dem/files/sha256.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/scene_settings.hpp"
#include "dem/scene/units.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::string_view between = " = ";

/// Walks the declarations of a scene along its document.
class KeyWalk {
 public:
  explicit KeyWalk(const SceneText& scene) : directory_(std::filesystem::path(scene.name).parent_path()) {}

  void walk(const std::vector<KeyDeclaration>& keys, const YAML::Node& node, const std::string& path) {
    for (const KeyDeclaration& key : keys) {
      const YAML::Node value = node && node.IsMap() ? node[key.name] : YAML::Node(YAML::NodeType::Undefined);
      take(key, value, path + key.name);
    }
  }

  SceneKeys found;

 private:
  void take(const KeyDeclaration& key, const YAML::Node& value, const std::string& path) {
    const bool there = value && !value.IsNull();
    if (key.list && there) {
      for (std::size_t n = 0; n < value.size(); ++n)
        walk(key.keys, value[n], fmt::format("{}[{}].", path, n));
    } else if (!key.keys.empty() && (there || (key.otherwise.empty() && !key.must && !key.list))) {
      walk(key.keys, value, path + ".");
    } else {
      put(path, there ? text_of(key, value) : key.otherwise);
    }
  }

  void put(const std::string& path, std::string value) {
    const auto is_control = [](unsigned char c) { return c < 0x20; };
    std::ranges::replace_if(value, is_control, '?');
    found.push_back({path, std::move(value)});
  }

  std::string text_of(const KeyDeclaration& key, const YAML::Node& value) const {
    if (value.IsSequence()) {
      std::string all;
      for (const auto& one : value) all += (all.empty() ? "" : ", ") + text_of(key, one);
      return "[" + all + "]";
    }
    const std::string typed = value.IsScalar() ? value.Scalar() : "";
    if (key.file) return content_of(typed);
    if (key.unit.empty()) return typed;
    try {
      return fmt::format("{}", units_.to_si(typed, key.unit));
    } catch (const UnitError&) {
      return typed;  // a word in place of a number
    }
  }

  std::string content_of(const std::string& file) const {
    constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
    try {
      return "SHA-256 " + sha256(read_scene_text(directory_ / file, any).text);
    } catch (const SceneError&) {
      return file;
    }
  }

  std::filesystem::path directory_;
  Units units_;
};

}  // namespace

SceneKeys scene_keys(const SceneText& scene) {
  const YAML::Node document = settled_document(scene);
  const YAML::Node kind = document.IsMap() ? document["scene"] : YAML::Node();
  for (const SceneKind& known : scene_kinds()) {
    if (!kind || !kind.IsScalar() || kind.Scalar() != known.name) continue;
    KeyWalk all(scene);
    all.walk(known.keys(), document, "");
    return all.found;
  }
  throw SceneError(scene.name + ": has no known `scene:`");
}

std::string to_text(const SceneKeys& keys) {
  std::string text;
  for (const KeyValue& key : keys) text += fmt::format("{}{}{}\n", key.path, between, key.value);
  return text;
}

SceneKeys scene_keys_in(const std::string& text) {
  SceneKeys keys;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size()), cut = text.find(between, at);
    if (cut < end) keys.push_back({text.substr(at, cut - at), text.substr(cut + 3, end - cut - 3)});
    at = end + 1;
  }
  return keys;
}

std::optional<std::string> value_in(const SceneKeys& keys, const std::string& path) {
  const auto found = std::ranges::find(keys, path, &KeyValue::path);
  if (found == keys.end()) return std::nullopt;
  return found->value;
}

std::vector<KeyChange> changes_between(const SceneKeys& before, const SceneKeys& after) {
  std::vector<KeyChange> changes;
  for (const KeyValue& key : after) {
    const auto was = value_in(before, key.path);
    if (was != key.value) changes.push_back({key.path, was.value_or(""), key.value});
  }
  for (const KeyValue& key : before) {
    if (!value_in(after, key.path)) changes.push_back({key.path, key.value, ""});
  }
  return changes;
}

std::vector<KeyChange> physical(std::vector<KeyChange> changes) {
  std::erase_if(changes, [](const KeyChange& change) {
    const std::string& path = change.path;
    const bool output = path.starts_with("output.") && path != "output.energy";
    return output || path == "duration" || path == "steps" || path.starts_with("start_from");
  });
  return changes;
}

std::string in_words(const KeyChange& change) {
  const auto words = [](const std::string& value) { return value.empty() ? "not given" : value; };
  return fmt::format("{}: {}, was {}", change.path, words(change.after), words(change.before));
}

}  // namespace fiberchain::dem
