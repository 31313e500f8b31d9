#pragma once

#include <string_view>
#include <vector>

#include "compare/material/material_values.hpp"
#include "dem/material/frequency_band.hpp"
#include "dem/model/fiber.hpp"
#include "reference/complex_modes.hpp"
#include "reference/thermoelastic.hpp"

// Fibers that differ in what damps them.
namespace fiberchain::compare {

enum class Damper { viscous, flat, thermoelastic };

std::string_view name(Damper damper);

/// Elastic wire of that metal. Diameter in m.
dem::Fiber metal_wire(const MetalValues& metal, double diameter, int aspect_ratio);

/// The fiber with a loss factor that is the same over the band, in stretch, shear, twist and bending; its
/// moduli are the storage moduli at `frequency` [Hz].
dem::Fiber with_flat_loss(const dem::Fiber& elastic, double loss_factor, dem::FrequencyBand band,
                          double frequency);

/// The fiber with the branches of thermoelasticity in bending, to 1 % up to `highest` [Hz].
dem::Fiber with_thermoelasticity(const dem::Fiber& elastic, const MetalValues& metal, double highest);

/// The fiber with the paper's dashpots, xi_b so that the first bending mode has this damping ratio. Throws
/// InputError where there is none.
dem::Fiber with_viscous_damping(const dem::Fiber& elastic, double damping);

/// The same wire as the reference has it.
reference::ThermoelasticWire reference_wire(const MetalValues& metal, double diameter);

/// The lowest bending modes of the clamped linear chain whose bending springs have the exact thermoelastic
/// modulus, no branches.
std::vector<reference::ComplexChainMode> exact_thermoelastic_modes(const dem::Fiber& elastic,
                                                                   const MetalValues& metal, int count);

/// First bending frequency of the clamped elastic chain [Hz].
double first_frequency(const dem::Fiber& elastic);

/// Diameter [m] of that metal's wire whose first bending frequency is `ratio` of its thermoelastic peak.
double diameter_at_peak(const MetalValues& metal, int aspect_ratio, double ratio = 1);

/// An aluminium wire at its thermoelastic peak and two fibers of the same size with the same damping ratio of
/// mode 1: one whose loss factor is flat from a third of its first frequency on over three decades (5
/// branches), one with the paper's dashpots.
struct ThreeFibers {
  MetalValues metal;
  double diameter;  ///< [m]
  dem::Fiber elastic;
  dem::FrequencyBand band;
  dem::Fiber viscous, flat, thermoelastic;

  const dem::Fiber& of(Damper damper) const;
};
ThreeFibers three_fibers(const MetalValues& metal, int aspect_ratio);

/// The same with a loss factor of one's choice at the first frequency, viscous and flat; elastic in place of
/// thermoelastic.
ThreeFibers with_loss_factor(const ThreeFibers& fibers, double loss_factor);

inline constexpr Damper kDampers[] = {Damper::viscous, Damper::flat, Damper::thermoelastic};

}  // namespace fiberchain::compare
