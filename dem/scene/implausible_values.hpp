#pragma once

#include <string>
#include <vector>

#include "dem/scene/scene_text.hpp"

namespace fiberchain::dem {

/// A line for every value of a scene that is read as no material, fiber or fluid has it, "FILE:LINE: KEY:
/// ...", with its reading and, for a unit that is likely mistyped (mPa, a bare 2 for 2 mm), the one that may
/// be meant. Such values are allowed.
/// @throws SceneError if the text is no YAML
std::vector<std::string> implausible_values(const SceneText& text);

}  // namespace fiberchain::dem
