#pragma once

#include "compare/damping_point.hpp"

// What the references say of a case of damping_point.hpp.
namespace fiberchain::compare {

struct DampingReferences {
  double beam;         ///< uniform Kelvin-Voigt beam, tau omega_1 / 2
  double closed_form;  ///< the same with (r_f + 1/2)^2 for r_f^2
  double unsheared;    ///< linear chain whose bonds cannot shear
  double modes;        ///< linear chain
  double elastica;     ///< damped Elastica, measured like the chain; NaN unless asked for
  double mode_2_estimate;
};

/// `clean` are the peaks that fiber_damping is measured on, of a release from the first mode or from equilibrium.
DampingReferences damping_references(const DampingCase& asked, const reference::ChainMode& mode, PeakRange clean,
                                     bool from_mode, bool with_elastica);

/// Deflection of the damped Elastica's free end with the chain's mass layout, over L; times in units of `unit` seconds.
TipHistory elastica_history(const DampingCase& asked, bool from_mode, double periods, int samples_per_period);

}  // namespace fiberchain::compare
