#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dem/scene/located_error.hpp"
#include "dem/scene/scene.hpp"

// Scenes as Python gives them: a text, and settings in place of what it says.
namespace fiberchain::python {

using Settings = std::vector<std::pair<std::string, std::string>>;

inline dem::SceneText scene_text(const std::string& text, const std::string& name, const Settings& settings) {
  dem::SceneText all{name, text};
  for (const auto& [key, value] : settings) all.settings.push_back({key, value});
  return all;
}

/// The scene of a kind. Throws SceneError for others.
template <class Kind>
Kind scene_of(const dem::SceneText& text) {
  dem::Scene scene = dem::parse_scene(text);
  if (auto* found = std::get_if<Kind>(&scene)) return std::move(*found);
  throw dem::SceneError(text.name + ": scene: another kind is needed here");
}

/// While it lives no other thread of this process reads or writes trajectories: HDF5 bears one at a time.
class FilesInUse {
 public:
  FilesInUse() {
    if (busy().exchange(true))
      throw std::runtime_error(
          "another thread of this process runs a packing or reads a trajectory: one at a time");
  }
  ~FilesInUse() { busy() = false; }
  FilesInUse(const FilesInUse&) = delete;
  FilesInUse& operator=(const FilesInUse&) = delete;

 private:
  static std::atomic<bool>& busy() {
    static std::atomic<bool> flag{false};
    return flag;
  }
};

}  // namespace fiberchain::python
