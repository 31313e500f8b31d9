#pragma once

#include "dem/record/table.hpp"
#include "dem/scene/scene.hpp"

namespace fiberchain::compare {

/// The scene as a run would begin with it: with the fibers of the file that a packing starts from. Throws as
/// dem::with_start_file().
dem::Scene scene_to_check(const dem::SceneText& text);

/// One row: size, time step, expected time, memory and files of a scene, which is not run. Packings measure
/// the cost of a step for some 50 ms; chains alone have a stated one. Throws dem::InvalidInput for what a run
/// would refuse before its first step, but for fibers that do not fit.
dem::Table scene_check_table(const dem::Scene& scene, int threads);

}  // namespace fiberchain::compare
