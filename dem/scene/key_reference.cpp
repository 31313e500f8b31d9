#include "dem/scene/key_reference.hpp"

#include <algorithm>

#include "dem/scene/scene.hpp"

namespace fiberchain::dem {
namespace {

std::string default_of(const KeyDeclaration& key) {
  if (!key.otherwise.empty()) return key.otherwise;
  return key.must ? "required" : "as below";
}

/// One row a key, those of nested mappings by their whole path.
void append_rows(const std::vector<KeyDeclaration>& keys, const std::string& path, std::string& text) {
  for (const KeyDeclaration& key : keys) {
    const std::string name = path + key.name;
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", name, key.unit, key.allowed, default_of(key),
                        key.meaning);
    append_rows(key.keys, name + (key.list ? "[]." : "."), text);
  }
}

}  // namespace

std::string key_reference() {
  std::string text;
  for (const SceneKind& kind : scene_kinds()) {
    text += fmt::format("{}### `scene: {}`\n\n", text.empty() ? "" : "\n", kind.name);
    text += "| key | unit | allowed | default | meaning |\n|---|---|---|---|---|\n";
    append_rows(kind.keys(), "", text);
  }
  return text;
}

}  // namespace fiberchain::dem
