#pragma once

#include <stdexcept>

namespace fiberchain::dem {

/// A scene that cannot be used. The message is one line: file, line, key, value, what is allowed.
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fiberchain::dem
