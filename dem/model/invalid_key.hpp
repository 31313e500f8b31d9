#pragma once

#include <string>
#include <utility>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {

/// An input that is not allowed, and the key of a scene that gives it, with as many of those that lead to it
/// as tell it from others: "step_ratio", "motion.step", "fibers[0].density".
struct InvalidKey : InvalidInput {
  InvalidKey(std::string at, const std::string& message) : InvalidInput(message), key(std::move(at)) {}

  std::string key;
};

}  // namespace fiberchain::dem
