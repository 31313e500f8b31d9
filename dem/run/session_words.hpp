#pragma once

#include <string>

#include "dem/run/files.hpp"
#include "dem/run/samples.hpp"
#include "dem/scene/packing_scene.hpp"

// What a run says of itself when it begins and ends.
namespace fiberchain::dem {

/// The step's origin and limits.
std::string step_words(const StepChoice& choice, const PackingScene& scene);

/// What the fibers weigh.
std::string mass_words(const PackingScene& scene);

/// How deep bodies went into each other up to the last moment, with warnings where that is too deep.
void say_how_deep(const RunMoment& last, double longest_path, const Say& say);

}  // namespace fiberchain::dem
