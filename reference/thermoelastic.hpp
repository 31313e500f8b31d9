#pragma once

#include "reference/complex_modes.hpp"
#include "reference/prony_series.hpp"

// Thermoelastic damping of a round wire that bends slowly against its sound: the side that is compressed
// warms, heat flows across the section, and the stiffness relaxes from adiabatic to isothermal. With strain
// kappa r cos(phi) and an insulated surface the temperature theta(r) cos(phi) obeys
//   rho c s (theta + (E alpha T/(rho c)) kappa r) = k (theta'' + theta'/r - theta/r^2),  theta'(R) = 0,
// and the moment is E I kappa - pi E alpha int_0^R theta r^2 dr. That one relaxation time
// (Zener's approximation) deviates slightly from the exact form is said by R. Lifshitz and M. L. Roukes,
// Phys. Rev. B 61 (2000) 5600, of beams with a rectangular section.
namespace fiberchain::reference {

struct ThermoelasticWire {
  double radius;       ///< R [m]
  double modulus;      ///< E, isothermal [Pa]
  double expansion;    ///< alpha, linear [1/K]
  double temperature;  ///< T [K]
  double density;      ///< rho [kg/m^3]
  /// c [J/(kg K)] at a held axial strain and free sides; the c_p of tables is 1 + Delta of it.
  double specific_heat;
  double conductivity;  ///< k [W/(m K)]
};

/// Delta = E alpha^2 T/(rho c): adiabatic over isothermal bending stiffness, less 1. As all here, throws
/// InvalidArgument unless every number of the wire is positive (alpha may be negative).
double relaxation_strength(const ThermoelasticWire& wire);

/// D = k/(rho c) [m^2/s].
double thermal_diffusivity(const ThermoelasticWire& wire);

/// Zener's peak, f_0 = q_1^2 D/(2 pi R^2) = 0.5395 D/R^2 [Hz].
double thermoelastic_peak(const ThermoelasticWire& wire);

/// q_k, the k-th zero of J_1'(q), from 1 to 1e6: 1.8412, 5.3314 ...
double thermal_mode_zero(int k);

/// f_k = 8/(q_k^2 (q_k^2 - 1)), the part of Delta that the k-th thermal mode has; their sum is 1.
double thermal_mode_weight(int k);

/// Exact: E(s)/E = 1 + Delta (1 - 4 I_2(z)/(z^2 I_1'(z))), z^2 = s R^2/D, I_1(z) = -i J_1(i z).
ComplexModulus thermoelastic_modulus(const ThermoelasticWire& wire);

/// The same as the sum over the first `terms` thermal modes: g_k = Delta f_k, tau_k = R^2/(D q_k^2).
PronySeries thermoelastic_series(const ThermoelasticWire& wire, int terms);

/// Zener's approximation: the first mode's time with all of Delta.
PronySeries zener_series(const ThermoelasticWire& wire);

/// How many terms of the series bring K'' to within `tolerance` of the exact one at f = frequency_ratio f_0.
/// frequency_ratio up to 1e8. Throws NoConvergence beyond 1e6 terms.
int thermoelastic_terms(double frequency_ratio, double tolerance);

/// E I = E pi R^4/4 and rho pi R^2.
UniformBeam wire_beam(const ThermoelasticWire& wire, double length);

}  // namespace fiberchain::reference
