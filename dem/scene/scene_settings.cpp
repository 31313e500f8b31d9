#include "dem/scene/scene_settings.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <optional>

#include "dem/files/nearest_word.hpp"
#include "dem/files/numbers.hpp"
#include "dem/scene/scene.hpp"
#include "dem/scene/yaml_document.hpp"

namespace fiberchain::dem {
namespace {

[[noreturn]] void refuse_setting(const SceneText& scene, const SceneSetting& setting,
                                 const std::string& reason) {
  throw SceneError(fmt::format("{}: setting {}={}: {}", scene.name, printable(setting.key),
                               printable(setting.value), reason));
}

/// One step of a path: "fibers[1]" or "contacts".
struct PathStep {
  std::string key;
  std::optional<std::int64_t> entry = {};
};

std::vector<PathStep> steps_of(const SceneText& scene, const SceneSetting& setting) {
  std::vector<PathStep> steps;
  for (std::size_t at = 0; at <= setting.key.size();) {
    const std::size_t end = std::min(setting.key.find('.', at), setting.key.size());
    PathStep step{setting.key.substr(at, end - at)};
    const std::size_t bracket = step.key.find('[');
    if (bracket != std::string::npos) {
      const std::string inside = step.key.substr(bracket + 1);
      if (inside.ends_with(']')) step.entry = parse_integer(inside.substr(0, inside.size() - 1));
      if (!step.entry || *step.entry < 0)
        refuse_setting(scene, setting,
                       fmt::format("'{}' is no entry of a list, such as fibers[0]", printable(step.key)));
      step.key.resize(bracket);
    }
    steps.push_back(std::move(step));
    at = end + 1;
  }
  return steps;
}

/// The keys of the scene's kind.
std::vector<KeyDeclaration> keys_of(const SceneText& scene, const YAML::Node& top) {
  const YAML::Node kind = top.IsMap() ? top["scene"] : YAML::Node();
  for (const SceneKind& known : scene_kinds()) {
    if (kind && kind.IsScalar() && kind.Scalar() == known.name) return known.keys();
  }
  throw SceneError(scene.name + ": has no known `scene:`, so that no key of it can be set");
}

const KeyDeclaration& declared(const SceneText& scene, const SceneSetting& setting,
                               const std::vector<KeyDeclaration>& keys, const std::string& path,
                               const std::string& key) {
  const auto found = std::ranges::find(keys, key, &KeyDeclaration::name);
  if (found != keys.end()) return *found;
  std::vector<std::string> known;
  for (const KeyDeclaration& one : keys) known.push_back(one.name);
  if (known.empty()) refuse_setting(scene, setting, fmt::format("'{}' has no keys below it", path));
  refuse_setting(scene, setting,
                 fmt::format("unknown key '{}{}'; {}", path.empty() ? "" : path + ".", printable(key),
                             dem::suggestion(key, known)));
}

/// The entry of a list that a step names.
YAML::Node entry_of(const SceneText& scene, const SceneSetting& setting, const YAML::Node& list,
                    const PathStep& step, const std::string& path) {
  const std::size_t size = list && list.IsSequence() ? list.size() : 0;
  if (!step.entry)
    refuse_setting(scene, setting,
                   fmt::format("'{}' is a list of {}: say of which, as {}[0]", path, size, path));
  if (static_cast<std::size_t>(*step.entry) >= size)
    refuse_setting(scene, setting, fmt::format("'{}' has {} entries, from [0] on", path, size));
  return list[static_cast<std::size_t>(*step.entry)];
}

/// `start_from: FILE` to the mapping that it stands for.
void lengthen(const YAML::Node& document) {
  if (!document.IsMap()) return;
  for (const auto& entry : document) {
    if (!entry.first.IsScalar() || entry.first.Scalar() != "start_from" || !entry.second.IsScalar()) continue;
    YAML::Node whole(YAML::NodeType::Map), key = entry.first, document_now = document;
    whole["file"] = entry.second.Scalar();
    document_now[key] = whole;
    return;
  }
}

YAML::Node value_of(const SceneText& scene, const SceneSetting& setting) {
  try {
    const YAML::Node value = YAML::Load(setting.value);
    if (value.IsDefined() && !value.IsNull()) return value;
  } catch (const YAML::Exception& error) {
    refuse_setting(scene, setting, "is no YAML: " + printable(error.msg));
  }
  refuse_setting(scene, setting, "has no value");
}

void apply_setting(const SceneText& scene, const SceneSetting& setting, const YAML::Node& top) {
  std::vector<KeyDeclaration> keys = keys_of(scene, top);
  const std::vector<PathStep> steps = steps_of(scene, setting);
  YAML::Node node = top;
  std::string path;
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const PathStep& step = steps[n];
    const KeyDeclaration key = declared(scene, setting, keys, path, step.key);
    path += (path.empty() ? "" : ".") + step.key;
    if (path == "scene") refuse_setting(scene, setting, "the kind of the scene stays as it is");
    if (step.entry && !key.list) refuse_setting(scene, setting, fmt::format("'{}' is no list", path));
    const bool last = n + 1 == steps.size();
    if (last && !key.list) {
      node[step.key] = value_of(scene, setting);
      return;
    }
    if (last) refuse_setting(scene, setting, fmt::format("'{}' is a list: set a key of an entry", path));
    YAML::Node below = node[step.key];
    if (!below && !key.list) {
      node[step.key] = YAML::Node(YAML::NodeType::Map);
      below.reset(node[step.key]);
    }
    if (key.list) {
      below.reset(entry_of(scene, setting, below, step, path));
      path += fmt::format("[{}]", *step.entry);
    }
    if (!below.IsMap()) refuse_setting(scene, setting, fmt::format("'{}' is no mapping there", path));
    node.reset(below);
    keys = key.keys;
  }
}

}  // namespace

YAML::Node settled_document(const SceneText& scene) {
  const YAML::Node document = read_document(scene.text, scene.name);
  lengthen(document);
  for (const SceneSetting& setting : scene.settings) apply_setting(scene, setting, document);
  if (!scene.settings.empty()) lengthen(document);
  return document;
}

std::string in_words(const std::vector<SceneSetting>& settings) {
  std::string words;
  for (const SceneSetting& setting : settings)
    words += fmt::format("{}{}={}", words.empty() ? "" : "; ", setting.key, setting.value);
  return words;
}

}  // namespace fiberchain::dem
