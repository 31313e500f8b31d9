#pragma once

#include <string>
#include <vector>

#include "compare/app/command.hpp"
#include "dem/scene/scene_text.hpp"

// Option --set: keys of a scene in place of what its file says.
namespace fiberchain::app {

/// A key and the values it takes one after the other, as a scene would have them.
struct SweptKey {
  std::string key;
  std::vector<std::string> values;

  bool operator==(const SweptKey&) const = default;
};

/// Option --set, which may come several times.
Option set_option();

/// "contacts.friction=0.2,0.4": commas within brackets and quotes belong to a value; ranges as everywhere,
/// "1..3", "0..1:0.25".
/// @throws compare::InputError naming option, text and what is allowed; for a key that comes twice
std::vector<SweptKey> swept_keys(const Arguments& arguments);

/// Every combination, the last key fastest; one without settings where there are no keys.
std::vector<std::vector<dem::SceneSetting>> combinations(const std::vector<SweptKey>& keys);

/// The scene with these settings.
/// @throws compare::InputError beginning with "--set KEY=VALUE" for those that it cannot have
dem::SceneText with_settings(dem::SceneText scene, const std::vector<dem::SceneSetting>& settings);

}  // namespace fiberchain::app
