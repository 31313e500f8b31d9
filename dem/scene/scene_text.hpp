#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace fiberchain::dem {

/// A value that takes the place of what a scene's text says: "contacts.friction", "0.4".
struct SceneSetting {
  std::string key;    ///< its path, "fibers[0].count"
  std::string value;  ///< as it would stand in the text

  bool operator==(const SceneSetting&) const = default;
};

/// A file as read: what the messages call it, and its text.
struct SceneText {
  std::string name;
  std::string text;
  std::vector<SceneSetting> settings = {};  ///< in their order
};

/// Largest scene file [bytes]. Long data belong in files the scene names.
inline constexpr std::size_t kLargestScene = 256 * 1024;

/// Reads the file.
/// @throws SceneError if there is none, it is a directory, it cannot be read, or it is too large
SceneText read_scene_text(const std::filesystem::path& path, std::size_t largest = kLargestScene);

}  // namespace fiberchain::dem
