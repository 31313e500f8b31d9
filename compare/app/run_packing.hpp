#pragma once

#include "compare/app/command.hpp"
#include "dem/scene/packing_scene.hpp"

namespace fiberchain::app {

/// `run` of a scene of many fibers: its files grow as it goes; signals stop it at a checkpoint.
int run_packing(const dem::SceneText& text, const dem::PackingScene& scene, const Arguments& arguments,
                Context& context);

}  // namespace fiberchain::app
