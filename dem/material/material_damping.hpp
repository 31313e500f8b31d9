#pragma once

#include <optional>

#include "dem/material/frequency_band.hpp"
#include "dem/material/thermoelastic.hpp"
#include "dem/model/fiber.hpp"

// How a material damps, and a fiber of it: branches beside the bonds' springs, and relaxed moduli.
namespace fiberchain::dem {

/// Mechanisms add. Without any the fiber is elastic.
struct MaterialDamping {
  std::optional<double> loss_factor;        ///< tan delta of Young's modulus [-]; over `band`
  std::optional<double> shear_loss_factor;  ///< of the shear modulus [-]; as loss_factor if left out
  std::optional<FrequencyBand> band;        ///< where the loss factors are flat [Hz]
  std::optional<int> branches;              ///< of each flat loss; else the fewest within `good_ripple`
  /// At which E and G are storage moduli [Hz]; left out: the geometric middle of the band, without one 0:
  /// relaxed.
  std::optional<double> modulus_frequency;
  std::optional<ThermalProperties> thermoelastic;  ///< of bending
  /// Up to which thermoelastic damping is met to 1 % [Hz]; left out: `fastest_frequency` of the fiber.
  std::optional<double> highest_frequency;
  MaterialRelaxation spectrum = {};  ///< more branches, as given
};

/// What the branches are like.
struct DampingSummary {
  MaterialRelaxation relaxation;    ///< all of them, of the moduli and of bending alone
  double ripple = 0;                ///< largest relative error of a flat loss factor in the band [-]
  double modulus_frequency = 0;     ///< [Hz]
  double relaxed_part = 1;          ///< E_inf over the E given
  double shear_relaxed_part = 1;    ///< G_inf over the G given
  double relaxation_strength = 0;   ///< Delta of the thermoelastic wire at the E given
  std::optional<double> peak = {};  ///< its f_0 [Hz]
};

struct DampedFiber {
  Fiber fiber;
  DampingSummary summary;
};

/// No motion of the chain is faster: 1 / (pi t_b) [Hz], t_b that of E as given.
double fastest_frequency(const Fiber& fiber);

/// The fiber with relaxed moduli and branches by its bond model; contacts keep the moduli given, by
/// `material.across`. Throws InvalidInput for a fiber that has branches already, a loss factor without a
/// band, a band without loss factor, and as flat_loss(), thermoelastic_branches() and check() do.
DampedFiber with_damping(Fiber fiber, const MaterialDamping& damping);

}  // namespace fiberchain::dem
