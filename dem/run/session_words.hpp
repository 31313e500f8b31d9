#pragma once

#include <string>

#include "dem/scene/packing_scene.hpp"

// What a run says of itself when it begins.
namespace fiberchain::dem {

/// The step's origin and limits.
std::string step_words(const StepChoice& choice, const PackingScene& scene);

/// What the fibers weigh.
std::string mass_words(const PackingScene& scene);

}  // namespace fiberchain::dem
