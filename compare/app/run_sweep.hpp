#pragma once

#include "compare/app/settings.hpp"

namespace fiberchain::app {

/// `run` of a scene with every combination of some keys' values: each by a process of its own, in a directory
/// of its own under that of the results, and a table NAME-sweep.csv of the keys and what the runs ended with.
/// One that fails keeps its row with the reason; --resume goes on with those that have not ended.
int run_sweep(const dem::SceneText& scene, const std::vector<SweptKey>& keys, const Arguments& arguments,
              Context& context);

}  // namespace fiberchain::app
