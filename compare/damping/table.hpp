#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compare/damping/case.hpp"
#include "compare/figures/figure.hpp"
#include "dem/record/table.hpp"

// The damped cantilever as tables and figures (Figs 6 to 9 of the paper).
namespace fiberchain::compare {

/// Every combination of these is a case.
struct DampingSweep {
  std::vector<int> aspect_ratio{10};
  std::vector<double> poisson_ratio{0.3};
  std::vector<double> bond_damping{1};
  std::vector<double> load{0.05};
  std::vector<dem::DashpotLaw> dashpots{dem::DashpotLaw::bond_damping};
  std::vector<dem::BondModel> bond{dem::BondModel::paper};
  std::vector<dem::BondForm> form{dem::BondForm::incremental};
  PeakRange peaks{1, 10};
};

std::vector<DampingCase> cases(const DampingSweep& sweep);

/// The cases of Figs 7, 8 and 9, of the nominal fiber where newton and pascal are asked for.
struct DampingFigureCases {
  std::vector<DampingCase>
      bond_damping;               ///< Fig 7: xi_b = 0.01 to 10 at r_f = 8 and 10, small load and P = 0.02 N
  std::vector<DampingCase> load;  ///< Fig 8: P = 0.00025 to 0.03 N, PL^2/EI = 0.05 to 6
  std::vector<DampingCase> modulus;       ///< Fig 8: G = 0.05 to 2 MPa at P = 0.002 N
  std::vector<DampingCase> aspect_ratio;  ///< Fig 9: r_f = 5 to 60
};
DampingFigureCases damping_figure_cases(PeakRange peaks);

/// A row per point.
dem::Table damping_table(const std::vector<DampingPoint>& points);

/// The first modes in bending, axial motion and twist, and the stable step, of each way to set the dashpots,
/// all with the same xi_f in the first bending mode as xi_b = 1 gives.
dem::Table dashpot_table(int aspect_ratio, double poisson_ratio);

/// Free end against time, chain beside damped Elastica (Fig 6).
dem::Table ring_down_table(const DampingCase& asked, double periods);

/// Figures by file name; the points of each as damping_figure_cases() has them.
struct DampingFigurePoints {
  std::vector<DampingPoint> bond_damping, load, modulus, aspect_ratio;
};
std::vector<std::pair<std::string, Figure>> damping_figures(const DampingFigurePoints& points,
                                                            const dem::Table& ring_down);

}  // namespace fiberchain::compare
