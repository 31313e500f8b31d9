#pragma once

#include <array>
#include <optional>
#include <vector>

#include "compare/contact/lone_spheres.hpp"
#include "compare/study/jobs.hpp"

namespace fiberchain::compare {

/// What shares no code with dem/ says of an impact: Hertz's closed forms where it is head on and elastic,
/// else CVODE on the differential equations of the contact (reference/two_spheres).
struct ImpactReference {
  ImpactOutcome outcome;  ///< force, overlap and time only where head on and elastic, else 0
  bool slides = false;    ///< throughout
  /// Rigid bodies that slide through, where it slides throughout.
  std::optional<std::array<reference::PlanarMotion, 2>> rigid = {};
};

ImpactReference impact_reference(const ImpactCase& impact);

/// Largest difference of velocities and radius times spin over the normal speed of the impact and, where the
/// reference has them, of force, overlap and time over their own values; of a restitution (test 3) over its
/// own.
double impact_error(const ImpactCase& impact, const ImpactOutcome& found, const ImpactReference& expected);
/// The same of velocities along the normal and across it against a rigid body's; spins stand aside: the arms
/// of spheres that overlap are shorter.
double rigid_error(const ImpactCase& impact, const ImpactOutcome& found,
                   const std::array<reference::PlanarMotion, 2>& rigid);

/// An impact at the default step and at parts of it, with the touch at several moments within a step.
struct ImpactPoint {
  ImpactCase impact;
  ImpactReference expected;
  double step;                           ///< the default one [s]
  ImpactOutcome found;                   ///< at the default step and the first phase
  std::vector<double> errors = {};       ///< largest over the phases, at each part of the step
  std::optional<double> rigid = {};      ///< likewise
  std::vector<double> mean_errors = {};  ///< root mean square over the phases, at each part of the step
};

struct ImpactPlan {
  std::vector<double> phases{0.1, 0.35, 0.6, 0.85};
  std::vector<double> parts{1};  ///< of the default step; the first is 1
};

std::vector<ImpactPoint> impact_points(const std::vector<ImpactCase>& impacts, const ImpactPlan& plan,
                                       const Jobs& jobs);

/// Exponent of the step in the mean error of all these points, by least squares over their parts of the step.
double observed_order(const std::vector<ImpactPoint>& points, const std::vector<double>& parts);

}  // namespace fiberchain::compare
