#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/rods/benchmark.hpp"
#include "compare/study/jobs.hpp"
#include "dem/record/table.hpp"

// How chains converge to the rods of the benchmarks.
namespace fiberchain::compare {

struct RodCase {
  std::string benchmark;
  RodSetting setting;
};

struct RodPoint {
  RodCase asked;
  double value, reference;  ///< the number that is shown
  double error;             ///< distance of all numbers from the rod's
  double error_doubled;     ///< with twice the bonds
  double order;             ///< log2 of the ratio
  double expected;
  std::string status;  ///< "converged", else the reason and every number is NaN, or not_begun
};

/// What is varied; a benchmark leaves out numbers of bonds that it cannot have.
struct RodSweep {
  std::vector<std::string> benchmark;  ///< none: all
  std::vector<int> aspect_ratio{20, 40};
  std::vector<double> poisson_ratio{0.17};
  std::vector<double> load_factor{1};  ///< of the benchmark's usual load, where it has one
  std::vector<dem::BondModel> bond{dem::BondModel::paper, dem::BondModel::corrected};
};

struct RodStudyOptions {
  Jobs jobs = 1;
  std::function<void()> advance = [] {};
  std::function<bool()> stopped = [] { return false; };  ///< then no more is begun: status not_begun
};

/// @throws InputError for a benchmark that there is not, or where no case is left
std::vector<RodCase> cases(const RodSweep& sweep);

std::vector<RodPoint> rod_points(const std::vector<RodCase>& cases, const RodStudyOptions& options = {});

/// Distance of the chain's numbers from the rod's. @throws dem::NoConvergence, reference::NoConvergence
double rod_error(const RodBenchmark& benchmark, const RodSetting& setting);

bool has_converged(const RodPoint& point);

dem::Table rods_table(const std::vector<RodPoint>& points);

/// A figure of every rod that a load bends, of Lee's frame's path, and of the orders.
std::vector<std::pair<std::string, Figure>> rod_figures(const Jobs& jobs);

}  // namespace fiberchain::compare
