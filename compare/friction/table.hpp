#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/friction/case.hpp"
#include "dem/record/table.hpp"

// Rolling friction of the bonds as tables and figures (Eq 21, Fig 10 of the paper).
namespace fiberchain::compare {

/// Every combination of these is a case.
struct RollingSweep {
  std::vector<int> aspect_ratio{30};
  std::vector<double> poisson_ratio{0.3};
  std::vector<double> load{3};
  std::vector<double> amplitude{};  ///< in place of load where not empty
  std::vector<double> bond_damping{1};
  std::vector<double> rolling_friction{0, 1, 2, 4, 10};
  std::vector<dem::Rolling> law{dem::Rolling::set_valued};
  std::vector<double> step_ratio{};  ///< empty: the default step
  PeakRange peaks{1, 5};
};

std::vector<RollingCase> cases(const RollingSweep& sweep);

/// The cases of Fig 10, all at xi_b = 1.
struct RollingFigureCases {
  std::vector<RollingCase> friction;   ///< r_f = 10, 20, 30, three loads, set-valued at its default step
  std::vector<RollingCase> step;       ///< the same by both laws at three steps
  std::vector<RollingCase> amplitude;  ///< r_f = 10, 30, from the first mode, tip deflection 0.003 to 0.5 L
  std::vector<RollingCase> decay;      ///< r_f = 30, twelve peaks
};
RollingFigureCases rolling_figure_cases(PeakRange peaks);

/// A row per point.
dem::Table rolling_table(const std::vector<RollingPoint>& points);

/// A row per peak.
dem::Table rolling_peaks_table(const std::vector<RollingPoint>& points);

/// Figures by file name; the points of each as rolling_figure_cases() has them.
struct RollingFigurePoints {
  std::vector<RollingPoint> friction, step, amplitude, decay;
};
std::vector<std::pair<std::string, Figure>> rolling_figures(const RollingFigurePoints& points);

}  // namespace fiberchain::compare
