#pragma once

#include <string>
#include <vector>

#include "compare/bench/kernels.hpp"

// What a scene saves that does not pay for what it lacks, all measured in one run, in turns.
namespace fiberchain::compare {

struct FeatureCostRow {
  std::string skipped;  ///< "planar instead of spatial"
  std::string scene;    ///< what is left
  double with;          ///< [s] of a bond-step, or of the whole answer, with what is skipped
  double without;

  double saving() const { return with / without; }
};

/// Every pair of inner loops that differ in one feature by the widest lanes, and one chain at a time against
/// full lanes.
std::vector<FeatureCostRow> kernel_feature_costs(const std::vector<KernelTime>& times);

/// Answers found without marching: equilibrium by Newton, damping by the eigenvalue, r_f = 10.
std::vector<FeatureCostRow> answer_costs(const BenchOptions& options);

/// A row per pair.
dem::Table feature_cost_table(const std::vector<FeatureCostRow>& rows);

/// A row per thing skipped: least, median and largest saving over its pairs.
dem::Table feature_cost_summary(const std::vector<FeatureCostRow>& rows);

}  // namespace fiberchain::compare
