#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/contact/points.hpp"
#include "compare/figures/figure.hpp"
#include "dem/record/table.hpp"

// Contacts of spheres as tables and figures.
namespace fiberchain::compare {

struct ContactPlan {
  std::vector<int> tests{1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<double> parts{1, 0.5, 0.25, 0.125};  ///< of the default step; the first is 1
};

struct ContactStudy {
  dem::Table table;  ///< a row an impact
  dem::Table steps;  ///< a row a test and a part of the step
  std::vector<std::pair<std::string, Figure>> figures = {};
};

/// Throws InputError for a test that there is not.
ContactStudy impact_study(const ContactPlan& plan, const Jobs& jobs);

dem::Table impact_table(const std::vector<ImpactPoint>& points);

/// Root mean square of the points' errors at part number k of the step.
double mean_error(const std::vector<ImpactPoint>& points, std::size_t k);

/// Slip over the normal speed after, positive in the sense before.
double recoil(const ImpactCase& impact, const ImpactOutcome& outcome);
double incidence(const ImpactCase& impact);

/// Figures of what there are points of.
std::vector<std::pair<std::string, Figure>> impact_figures(const std::vector<ImpactPoint>& points,
                                                           const std::vector<double>& parts);

}  // namespace fiberchain::compare
