#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dem/scene/scene_text.hpp"

// What a scene says, key by key, without how it says it.
namespace fiberchain::dem {

/// A key by its path, "fibers[0].diameter", and its value: quantities in SI units, words as typed, of files
/// their SHA-256, what holds where the key is left out.
struct KeyValue {
  std::string path, value;

  bool operator==(const KeyValue&) const = default;
};

/// All keys of a scene in the order of their declarations, those left out with their defaults: comments,
/// order and units of the text do not matter.
using SceneKeys = std::vector<KeyValue>;

/// Of a scene that parse_scene() has read.
/// @throws SceneError as parse_scene() for a text that is none
SceneKeys scene_keys(const SceneText& scene);

/// A line a key, "path = value".
std::string to_text(const SceneKeys& keys);
SceneKeys scene_keys_in(const std::string& text);

/// The value of a key; nothing if there is no such.
std::optional<std::string> value_in(const SceneKeys& keys, const std::string& path);

/// A key that two scenes differ in; a value that is not there is empty.
struct KeyChange {
  std::string path, before, after;

  bool operator==(const KeyChange&) const = default;
};

/// Those that differ, in the order of `after`, then those that it does not have.
std::vector<KeyChange> changes_between(const SceneKeys& before, const SceneKeys& after);

/// Without those that leave a packing's course as it is: files of its output, how long it lasts, and where
/// it starts from.
std::vector<KeyChange> physical(std::vector<KeyChange> changes);

/// "contacts.friction: 0.3, was 0.2".
std::string in_words(const KeyChange& change);

}  // namespace fiberchain::dem
