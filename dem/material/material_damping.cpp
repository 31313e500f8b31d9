#include "dem/material/material_damping.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/material/flat_loss.hpp"
#include "dem/material/merge.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

void check(const Fiber& fiber, const MaterialDamping& damping) {
  if (!fiber.branches.empty()) throw InvalidInput("the fiber has Maxwell branches already");
  const bool flat = damping.loss_factor || damping.shear_loss_factor;
  if (flat && !damping.band)
    throw InvalidInput("band is missing: a loss factor is flat over a band of frequencies");
  if (!flat && (damping.band || damping.branches))
    throw InvalidInput("loss_factor is missing: a band and its branches are those of a loss factor");
  if (damping.modulus_frequency &&
      !(*damping.modulus_frequency >= 0 && std::isfinite(*damping.modulus_frequency)))
    throw InvalidInput("modulus_frequency must be finite and 0 or greater");
}

/// The branches of one modulus: flat over the band, and those given.
PronySeries series_of(std::optional<double> loss, const MaterialDamping& damping, const PronySeries& given,
                      double& ripple) {
  if (!loss || *loss == 0) return tidy(given);
  const FlatLoss flat =
      damping.branches ? flat_loss(*loss, *damping.band, *damping.branches) : flat_loss(*loss, *damping.band);
  ripple = std::max(ripple, flat.ripple);
  return merge(flat.series, given);
}

double measured_at(const MaterialDamping& damping) {
  if (damping.modulus_frequency) return *damping.modulus_frequency;
  return damping.band ? std::sqrt(damping.band->low * damping.band->high) : 0.0;
}

/// Thermoelastic stiffness E^2 alpha^2 T / (rho c), E as given, over the relaxed one.
PronySeries thermal_series(const Fiber& fiber, const MaterialDamping& damping, DampingSummary& summary) {
  const ThermalProperties& thermal = *damping.thermoelastic;
  const Material& material = fiber.material;
  const double radius = sphere_radius(fiber), diffusivity = thermal_diffusivity(thermal, material.density);
  summary.relaxation_strength = relaxation_strength(thermal, material.youngs_modulus, material.density);
  summary.peak = thermal_peak(diffusivity, radius);
  return thermoelastic_branches(summary.relaxation_strength / summary.relaxed_part, diffusivity, radius,
                                damping.highest_frequency.value_or(fastest_frequency(fiber)));
}

}  // namespace

double fastest_frequency(const Fiber& fiber) { return 1 / (std::numbers::pi * bond_time_step(fiber)); }

DampedFiber with_damping(Fiber fiber, const MaterialDamping& damping) {
  check(fiber);
  check(fiber, damping);
  DampingSummary summary;
  MaterialRelaxation& relaxation = summary.relaxation;
  const std::optional<double> shear =
      damping.shear_loss_factor ? damping.shear_loss_factor : damping.loss_factor;
  relaxation.youngs_modulus =
      series_of(damping.loss_factor, damping, damping.spectrum.youngs_modulus, summary.ripple);
  relaxation.shear_modulus = series_of(shear, damping, damping.spectrum.shear_modulus, summary.ripple);
  summary.modulus_frequency = measured_at(damping);
  summary.relaxed_part = relaxed_part(relaxation.youngs_modulus, summary.modulus_frequency);
  summary.shear_relaxed_part = relaxed_part(relaxation.shear_modulus, summary.modulus_frequency);
  relaxation.bending = tidy(damping.spectrum.bending);
  if (damping.thermoelastic)
    relaxation.bending = merge(relaxation.bending, thermal_series(fiber, damping, summary));
  fiber.material.across = contact_elasticity(fiber.material);
  fiber.material.youngs_modulus *= summary.relaxed_part;
  fiber.material.shear_modulus *= summary.shear_relaxed_part;
  fiber.branches = maxwell_branches(relaxation, fiber.bond_model);
  check(fiber);
  return {std::move(fiber), std::move(summary)};
}

}  // namespace fiberchain::dem
