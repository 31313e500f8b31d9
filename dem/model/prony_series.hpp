#pragma once

#include <complex>
#include <vector>

namespace fiberchain::dem {

/// A Maxwell branch beside a spring: a spring and a dashpot in line.
struct MaxwellBranch {
  double strength;  ///< g: its spring's stiffness over the relaxed one beside it [-]
  double time;      ///< tau: within which it relaxes [s]
};

/// Relaxation of a stiffness, K(t) = K_inf (1 + sum g_j exp(-t / tau_j)) (generalized Maxwell model, e.g.
/// Ferry, Viscoelastic Properties of Polymers, 1980). No branch: elastic.
using PronySeries = std::vector<MaxwellBranch>;

/// K(s) / K_inf = 1 + sum g_j s tau_j / (1 + s tau_j), s = i omega in forced vibration [1/s].
std::complex<double> complex_modulus(const PronySeries& series, std::complex<double> s);

/// K' / K_inf at angular frequency omega [1/s].
double storage_modulus(const PronySeries& series, double omega);

/// tan delta = K'' / K' at angular frequency omega [1/s].
double loss_factor(const PronySeries& series, double omega);

/// K(0) / K_inf = 1 + sum g_j: of a sudden load.
double unrelaxed_modulus(const PronySeries& series);

/// Throws InvalidInput unless every strength is >= 0 and every time > 0, all finite.
void check(const PronySeries& series);

}  // namespace fiberchain::dem
