#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/static/case.hpp"
#include "compare/study/jobs.hpp"
#include "dem/record/table.hpp"

// The static cantilever as tables and figures (Figs 3 and 4 of the paper).
namespace fiberchain::compare {

/// Every combination of these is a case.
struct StaticSweep {
  std::vector<int> aspect_ratio{4, 6, 8, 10, 15, 20, 30, 50};
  std::vector<double> poisson_ratio{0.3};
  std::vector<double> load{0.05, 0.1, 0.2, 0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10};
  std::vector<dem::BondModel> bond{dem::BondModel::paper};
  std::vector<StaticMethod> method{StaticMethod::solve};
  std::vector<dem::BondForm> form{dem::BondForm::total};
  std::vector<int> dimension{2};
};

/// Cases with the load as the innermost loop, so that equal chains march side by side. The incremental form
/// is paired with marching only: asked for together with solve, it joins the march and leaves solve to the
/// total form. Throws InputError when that leaves nothing.
std::vector<StaticCase> cases(const StaticSweep& sweep);

/// A row per point.
dem::Table static_table(const std::vector<StaticPoint>& points);

/// Aspect ratios in turn at the same bond and load: departures and the order at which they vanish in 1 / r_f,
/// pairwise. Both bonds, loads 1 and 6, solved.
dem::Table static_order_table(double poisson_ratio, const Jobs& jobs);

/// Figures by file name: fig-3 (deflection against load), fig-4 (departure against load), static-budget (what
/// the departure consists of), static-order (departure against aspect ratio).
std::vector<std::pair<std::string, Figure>> static_figures(const std::vector<StaticPoint>& points,
                                                           const dem::Table& orders);

}  // namespace fiberchain::compare
