#pragma once

#include <vector>

#include "reference/beam_history.hpp"

namespace fiberchain::reference {

// Damped Euler-Bernoulli cantilever, dimensionless (beam_history.hpp), released at time 0:
//   w_tt + viscous w_t + w_ssss + retardation w_sssst = 0,
//   w = w_s = 0 at s = 0,  w_ss = w_sss = 0 (with their damped parts) at s = 1.

/// Damping of a beam.
struct BeamDamping {
  double retardation = 0;  ///< Kelvin-Voigt retardation time tau, over sqrt(mu L^4 / (E I))
  double viscous = 0;      ///< external damping c L^4 / (E I) over the same time unit
};

/// beta_n of the clamped-free beam, cos(beta) cosh(beta) = -1; n from 1. Throws InvalidArgument.
double clamped_free_beta(int n);

/// Damping ratio of mode n: (viscous + retardation beta_n^4) / (2 beta_n^2).
double damped_beam_ratio(const BeamDamping& damping, int n);

/// Tip history by the modal closed form: y = load sum_n 4/beta_n^4 T_n(t), T_n of the damped oscillator; the
/// terms left out are below load 4/(3 pi^4 terms^3). Energies are summed likewise; `dissipated` is what is
/// missing from the initial energy. Throws InvalidArgument.
BeamHistory damped_beam_modal(const BeamDamping& damping, const Release& release,
                              const std::vector<double>& times, int terms = 2000);

/// The same by CVODE on a Galerkin method with polynomials (curvature in Legendre polynomials). Wants some
/// Kelvin-Voigt damping if the release is from a static load: without it the vanishing load sends waves
/// into the beam that no number of modes resolves. Throws InvalidArgument, NoConvergence.
BeamHistory damped_beam_cvode(const BeamDamping& damping, const Release& release,
                              const std::vector<double>& times, const BeamResolution& resolution = {});

}  // namespace fiberchain::reference
