#pragma once

#include <vector>

#include "reference/beam_history.hpp"

namespace fiberchain::reference {

/// Mass and damping of an inextensible cantilever, dimensionless as in beam_history.hpp: masses over mu L,
/// inertias over mu L^3, rotary inertia per length over mu L^2, retardation over sqrt(mu L^4 / (E I)).
struct BeamLayout {
  double retardation = 0;     ///< Kelvin-Voigt: moment E I (kappa + tau kappa')
  double tip_mass = 0;        ///< point mass at s = L beyond the beam's own
  double tip_inertia = 0;     ///< of a body at s = L
  double rotary_inertia = 0;  ///< of the sections, per length
};

/// The chain of `bonds` bonds as a beam: spheres of mass m at s = l, 2 l, ..., L are a line mass mu = m/l and
/// half a sphere more at s = L (mass m/2, inertia J/2); J/l is the rotary inertia; the paper's bending
/// dashpot xi_b sqrt(2 J K_bend) is the retardation time xi_b sqrt(2 J/K_bend). Throws InvalidArgument.
BeamLayout chain_layout(int bonds, double bond_damping);

/// sqrt(mu L^4 / (E I)) of such a chain in units of its bond time t_b: 4 bonds^2.
double chain_time_unit(int bonds);

/// Motion of the beam after its release at time 0, at increasing times, by CVODE: inextensible, of any
/// amplitude, dead weightless; curvature in Legendre polynomials, analytic Jacobian. Throws InvalidArgument,
/// NoConvergence.
BeamHistory damped_elastica(const BeamLayout& layout, const Release& release,
                            const std::vector<double>& times, const BeamResolution& resolution = {});

/// Undamped linear frequencies omega_k of the layout, lowest first, as the discretization has them; the
/// damping ratio of each is retardation omega_k / 2. The upper third is not converged.
std::vector<double> beam_frequencies(const BeamLayout& layout, int modes = 16);

/// Coefficient c in omega/omega_0 = 1 + c (a/L)^2, the first mode's frequency at small tip amplitude a of the
/// uniform undamped beam, by averaging over one period: 0.019384. With phi scaled to phi(1) = 1,
/// c = (3/2 int (phi'' phi')^2 - omega_0^2/2 int (int_0^s phi'^2)^2) / (2 omega_0^2 int phi^2).
double amplitude_frequency_coefficient();

}  // namespace fiberchain::reference
