#pragma once

#include "dem/model/errors.hpp"
#include "dem/scene/scene_text.hpp"

namespace fiberchain::dem {

/// What is not allowed in a scene, found once it is worked with, as an error of its text: with the file, the
/// line and the key (InvalidKey), or the first line where no key is known.
/// @throws SceneError
[[noreturn]] void throw_located(const SceneText& scene, const InvalidInput& error);

/// Does some work with a scene.
/// @throws SceneError in place of InvalidInput
template <class Work>
auto located(const SceneText& scene, const Work& work) {
  try {
    return work();
  } catch (const InvalidInput& error) {
    throw_located(scene, error);
  }
}

}  // namespace fiberchain::dem
