#pragma once

#include "compare/damping/case.hpp"
#include "compare/measure/first_mode_damping.hpp"
#include "reference/cvode.hpp"

// What the references say of a case of point.hpp.
namespace fiberchain::compare {

struct DampingReferences {
  double beam;         ///< uniform Kelvin-Voigt beam, tau omega_1 / 2
  double closed_form;  ///< the same with (r_f + 1/2)^2 for r_f^2
  double unsheared;    ///< linear chain whose bonds cannot shear
  double modes;        ///< linear chain
  double elastica;     ///< damped Elastica, measured like the chain; NaN unless asked for
  double mode_2_estimate;
  reference::CvodeStatistics cvode;  ///< what the damped Elastica cost
};

/// `clean` are the peaks that fiber_damping is measured on. The damped Elastica's is NaN where its motion
/// does not show them.
DampingReferences damping_references(const DampingCase& asked, const reference::ChainMode& mode,
                                     const CleanPeaks& clean, bool with_elastica);

/// Deflection over L of the damped Elastica's free end with the chain's mass layout, let go from its
/// equilibrium, at times in seconds; `unit` is the beam's time unit [s].
TipHistory elastica_at(const DampingCase& asked, const std::vector<double>& times, double unit);

}  // namespace fiberchain::compare
