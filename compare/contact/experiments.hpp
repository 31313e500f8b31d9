#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fiberchain::compare {

/// Digitized points of others, data/experiments/oblique-impact.csv, which says whose.
struct ExperimentPoints {
  std::vector<double> x, y;
};

/// Those of one quantity. Throws InputError where the file is missing, or has none of them.
ExperimentPoints experiment_points(const std::string& experiment, const std::string& quantity);

}  // namespace fiberchain::compare
