#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/stability/growth.hpp"
#include "dem/record/table.hpp"

// The stability map as tables and figures.
namespace fiberchain::compare {

/// Every combination of these is a case. As they stand: the map over nu and xi_b.
struct StabilitySweep {
  std::vector<int> aspect_ratio{10};
  std::vector<double> poisson_ratio{-0.2, -0.1, 0, 0.1, 0.17, 0.25, 0.3, 0.4, 0.49};
  std::vector<double> bond_damping{0, 0.1, 0.25, 0.5, 1, 2, 5, 10};
  std::vector<dem::BondModel> bond{dem::BondModel::paper, dem::BondModel::corrected};
  std::vector<dem::Integrator> scheme{dem::Integrator::leapfrog, dem::Integrator::leapfrog_damped,
                                      dem::Integrator::leapfrog_stiff};
  std::vector<reference::ChainEnds> ends{reference::ChainEnds::clamped_free};
  std::vector<int> dimension{2};
  std::vector<dem::BondForm> form{dem::BondForm::incremental};
  std::vector<double> step_ratio{10, 100, 1000};  ///< of schemes without a stable step
};

/// Those of schemes with a stable step.
std::vector<StabilityCase> cases(const StabilitySweep& sweep);

/// Those of schemes without.
std::vector<GrowthCase> growth_cases(const StabilitySweep& sweep);

/// The map with the curve over the aspect ratio: r_f = 5 to 200 at nu = 0.3.
std::vector<StabilityCase> stability_figure_cases();

/// What goes with it of schemes without a stable step: r_f = 5 to 200, nu = -0.2 to 0.49, xi_b = 0 to 10,
/// both forms, plane and space.
std::vector<GrowthCase> growth_figure_cases();

/// A row per point.
dem::Table stability_table(const std::vector<StabilityPoint>& points);

/// What the points say of theory against measurement and of the paper's rules, as Markdown.
std::string stability_notes(const std::vector<StabilityPoint>& points);

/// A row for each step of each point.
dem::Table growth_table(const std::vector<GrowthPoint>& points);

/// What these say of modes against runs and of the paper's rule that the step be t_b, as Markdown.
std::string growth_notes(const std::vector<GrowthPoint>& points);

/// Figures by file name: for each bond and scheme a heat map (where nu and xi_b span a grid), curves over
/// xi_b and curves over r_f, as far as there are points for them.
std::vector<std::pair<std::string, Figure>> stability_figures(const std::vector<StabilityPoint>& points);

}  // namespace fiberchain::compare
