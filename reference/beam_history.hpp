#pragma once

#include <vector>

#include "reference/cvode.hpp"

namespace fiberchain::reference {

/// State of a vibrating cantilever at one time, dimensionless: lengths over L, times over
/// sqrt(mu L^4 / (E I)), energies over E I / L; mu is the mass per length.
struct BeamSample {
  double time;
  double y;      ///< deflection of the free end
  double x;      ///< shortening of the free end; 0 in linear theory
  double angle;  ///< rotation of the end section [rad]
  double y_rate;
  double x_rate;
  double angle_rate;
  double kinetic;     ///< kinetic energy
  double elastic;     ///< bending energy
  double dissipated;  ///< energy lost to the damping since the release
};

/// The samples asked for and what they cost (all zero where CVODE was not used).
struct BeamHistory {
  std::vector<BeamSample> samples;
  CvodeStatistics statistics;
};

/// How the beam is let go, at rest, at time 0.
struct Release {
  enum class Shape {
    static_load,  ///< the equilibrium under the dead tip load P L^2/(E I) = amount, which then vanishes
    first_mode    ///< the undamped first linear mode with tip deflection amount (over L)
  };
  Shape shape = Shape::static_load;
  double amount = 0;
};

/// Size and accuracy of a beam's discretization in arc length and time.
struct BeamResolution {
  int modes = 16;  ///< Legendre polynomials that the curvature is expanded in, 2 to 60
  CvodeMethod method = CvodeMethod::bdf;
  CvodeTolerances tolerances{};
};

/// Throws InvalidArgument unless the times are finite, not negative and increase strictly.
void require_times(const std::vector<double>& times);

}  // namespace fiberchain::reference
