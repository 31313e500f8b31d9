#pragma once

#include "compare/app/command.hpp"
#include "dem/io/packing_scene.hpp"

namespace fiberchain::app {

/// `run` of a scene of many fibers: its files grow as it goes; signals stop it at a checkpoint.
int run_packing(const dem::io::SceneText& text, const dem::io::PackingScene& scene,
                const Arguments& arguments, Context& context);

}  // namespace fiberchain::app
