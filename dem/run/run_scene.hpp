#pragma once

#include <filesystem>
#include <variant>

#include "dem/run/run_fiber.hpp"
#include "dem/run/run_packing.hpp"

namespace fiberchain::dem {

using SceneResult = std::variant<CantileverResult, ReleaseResult, FlowResult, RodResult, PackingEndState>;

/// Reads a scene file and runs it. A packing writes its files as it goes, the other kinds return their result
/// only.
/// @throws SceneError naming file, line, key and what is allowed; else as the run_scene() of the kind
SceneResult run_scene(const std::filesystem::path& path, const RunOptions& options = {});

}  // namespace fiberchain::dem
