#pragma once

#include "dem/model/prony_series.hpp"

// Thermoelastic damping of a round wire in bending: what is compressed gets warm, and heat that flows across
// the wire is lost (Zener, Phys. Rev. 52 (1937) 230). dem/material/README.md derives it.
namespace fiberchain::dem {

struct ThermalProperties {
  double expansion;      ///< alpha: linear [1/K]
  double temperature;    ///< T [K]
  double heat_capacity;  ///< c: at constant stress [J/(kg K)]
  double conductivity;   ///< k [W/(m K)]
};

/// Zener's relaxation strength Delta = E alpha^2 T / (rho c) of an isothermal modulus [Pa] and a density
/// [kg/m^3], to first order in itself: Delta / (1 - Delta) is exact for uniaxial stress. Throws InvalidInput
/// unless all are above 0 (expansion: any finite) and the strength is below 1.
double relaxation_strength(const ThermalProperties& properties, double youngs_modulus, double density);

/// D = k / (rho c) [m^2/s]. Throws InvalidInput as above.
double thermal_diffusivity(const ThermalProperties& properties, double density);

/// Of the first thermal mode, where the loss factor peaks but for the further ones: 1.8412^2 D / (2 pi R^2) =
/// 0.5395 D / R^2 [Hz].
double thermal_peak(double diffusivity, double radius);

/// The first `count` thermal modes of the wire with an insulated surface as branches, g_k = Delta w_k with
/// w_k = 8 / (q_k^2 (q_k^2 - 1)), tau_k = R^2 / (D q_k^2), J_1'(q_k) = 0. All of them have sum w_k = 1: K_inf
/// is isothermal, K(0) adiabatic. Throws InvalidInput unless strength >= 0, the others > 0.
PronySeries thermal_modes(double strength, double diffusivity, double radius, int count);

/// The fewest branches with which tan delta is that of all thermal modes within a relative tolerance from 0
/// to the highest frequency [Hz]; their largest error is the least that as many can have. At least up to the
/// peak, and beyond 1e7 times its frequency the error grows by a thirtieth of itself at most: 3 branches are
/// within 1 % everywhere. Without strength no branch. Throws InvalidInput unless 0 <= strength <= 1, 0.001 <=
/// tolerance <= 1, the others are finite and > 0.
PronySeries thermoelastic_branches(double strength, double diffusivity, double radius,
                                   double highest_frequency, double tolerance = 0.01);

}  // namespace fiberchain::dem
