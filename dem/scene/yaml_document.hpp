#pragma once

#include <yaml-cpp/node/node.h>

#include <string>
#include <string_view>

namespace fiberchain::dem {

/// Text of a user's file as it may stand in a one-line message: short and printable ASCII.
std::string printable(std::string_view text);

/// The one YAML document of a text; `name` is what messages call the file.
/// @throws SceneError if it is no YAML, nested too deeply, empty, or followed by anything else
YAML::Node read_document(const std::string& text, const std::string& name);

}  // namespace fiberchain::dem
