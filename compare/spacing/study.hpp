#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compare/figures/figure.hpp"
#include "compare/study/jobs.hpp"
#include "dem/model/fiber.hpp"
#include "dem/record/table.hpp"

// A fiber cut into fewer or more bonds than it is diameters long: what that does to its statics, its first
// mode, its damping and its time step.
namespace fiberchain::compare {

/// One clamped fiber of the mass of its cylinder. Everything is dimensionless.
struct SpacingCase {
  int aspect_ratio = 60;  ///< r_f = L / d
  double spacing = 1;     ///< s = l / d
  double poisson_ratio = 0.3;
  double load = 1;  ///< P L^2 / (E I) at the free end
  dem::BondModel bond = dem::BondModel::paper;
};

struct SpacingPoint {
  SpacingCase asked;
  int bonds;
  double distance;              ///< |dr| / L of the free end from the Elastica
  double distance_unstretched;  ///< the same from the Elastica that stretches as the bonds do
  double frequency_error;       ///< of the first mode over that of the uniform slender beam, less 1
  double damping_ratio;         ///< xi_f / xi_b of the first mode at small damping
  double damping_law_error;     ///< that over damping_law(), less 1
  double stable_step;           ///< largest stable step over that of the paper's bonds at s = 1, no dashpots
  std::string status = "converged";  ///< or not_begun
};

/// What is varied. Spacings that do not make whole bonds of an aspect ratio are left out.
struct SpacingSweep {
  std::vector<int> aspect_ratio{20, 60, 120, 240};
  std::vector<double> spacing{0.5, 1, 2, 3, 4, 5};
  std::vector<double> poisson_ratio{0.3};
  std::vector<double> load{1, 6};
  std::vector<dem::BondModel> bond{dem::BondModel::paper, dem::BondModel::corrected};
};

struct SpacingOptions {
  Jobs jobs = 1;
  std::function<void()> advance = [] {};
  std::function<bool()> stopped = [] { return false; };  ///< then no more is begun: status not_begun
};

/// @throws InputError where nothing is left
std::vector<SpacingCase> cases(const SpacingSweep& sweep);

/// The fiber of a case. @throws InputError where its bonds are not whole
dem::Fiber spaced_fiber(const SpacingCase& asked);

/// @throws dem::InvalidInput, reference::InvalidArgument for a case out of range
std::vector<SpacingPoint> spacing_points(const std::vector<SpacingCase>& cases,
                                         const SpacingOptions& options = {});

/// xi_f of the first mode of a clamped fiber with the paper's dashpots, many bonds and little damping:
/// (beta_1^2 / sqrt(20)) xi_b s / (r_f + 1/2)^2 of spheres, beta_1^2 / 4 xi_b s / r_f^2 of the cylinder's
/// mass.
double damping_law(const dem::Fiber& fiber);

/// What a fiber is asked for.
enum class SpacingGoal { statics, first_mode };

/// The fewest bonds of the corrected bond that err no more than a limit, bonds of the spacing down to 1/2.
struct FewestBonds {
  int aspect_ratio;
  SpacingGoal goal;
  double load;          ///< of statics
  double touching;      ///< error of the paper's touching spheres
  double wanted;        ///< error that is allowed
  int bonds;            ///< 0: no number of them is enough
  double error;         ///< of those
  double times_fewer;   ///< r_f over them
  double longest_step;  ///< largest stable step over that of the paper's touching spheres
};

/// @param wanted of the distance |dr| / L from the Elastica, or of the frequency; 0: that of the paper's
/// touching spheres
FewestBonds fewest_bonds(int aspect_ratio, double poisson_ratio, SpacingGoal goal, double load,
                         double wanted);

/// Distance of the free end and error of the first frequency against the number of bonds, a series for each
/// aspect ratio and bond, statics at the first load.
std::vector<std::pair<std::string, Figure>> spacing_figures(const std::vector<SpacingPoint>& points);

dem::Table spacing_table(const std::vector<SpacingPoint>& points);

/// For every aspect ratio and load of a sweep: as good as touching spheres, and within 1e-3 and 1e-4.
dem::Table fewest_bonds_table(const SpacingSweep& sweep, const Jobs& jobs);

}  // namespace fiberchain::compare
