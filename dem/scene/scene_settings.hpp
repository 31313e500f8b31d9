#pragma once

#include <yaml-cpp/node/node.h>

#include <string>
#include <vector>

#include "dem/scene/scene_text.hpp"

namespace fiberchain::dem {

/// The document of a scene with its settings in place of what the text says; what it does not say is added.
/// @throws SceneError as read_document(); for a setting naming its key and what is allowed: a key that the
/// kind of scene does not have, an entry that a list does not have, no value
YAML::Node settled_document(const SceneText& scene);

/// All settings as typed, "key=value; key=value"; "" if there are none.
std::string in_words(const std::vector<SceneSetting>& settings);

}  // namespace fiberchain::dem
