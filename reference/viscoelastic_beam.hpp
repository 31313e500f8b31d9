#pragma once

#include <vector>

#include "reference/damped_beam.hpp"
#include "reference/prony_series.hpp"

namespace fiberchain::reference {

// Euler-Bernoulli cantilever of a generalized Maxwell material, dimensionless (beam_history.hpp, times and
// relaxation times over sqrt(mu L^4/(E_inf I)), energies over E_inf I/L):
//   w_tt + viscous w_t + d^2/ds^2 (w_ss + retardation w_sst + sum g_j x_j) = 0,
//   x_j' = w_sst - x_j/tau_j,
// x_j the curvature that the spring of branch j bears.

/// What damps the beam.
struct ViscoelasticDamping {
  PronySeries spectrum;  ///< strengths [-] and dimensionless times
  BeamDamping beside{};  ///< Kelvin-Voigt and external damping
};

/// A shape that the beam was held in until the branches had relaxed, let go at rest at time 0: that of a dead
/// tip load P L^2/(E_inf I) plus elastic modes 1, 2 ... with the tip deflections (over L) given.
struct HeldShape {
  double load = 0;
  std::vector<double> modes{};
};

/// Tip history by CVODE on the Galerkin method of damped_beam_cvode(), with the branches' curvatures as
/// further unknowns. `elastic` is what all springs store, the branches' too. Without Kelvin-Voigt damping a
/// load that vanishes sends waves into the beam that no number of modes resolves: give modes then. Throws
/// InvalidArgument (also for more modes in the shape than in the resolution), NoConvergence.
BeamHistory viscoelastic_beam(const ViscoelasticDamping& damping, const HeldShape& shape,
                              const std::vector<double>& times, const BeamResolution& resolution = {});

}  // namespace fiberchain::reference
