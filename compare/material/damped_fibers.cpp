#include "compare/material/damped_fibers.hpp"

#include <cmath>
#include <numbers>

#include "compare/measure/bond_spectra_of.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/study/errors.hpp"
#include "dem/material/material_damping.hpp"

namespace fiberchain::compare {

std::string_view name(Damper damper) {
  switch (damper) {
    case Damper::viscous:
      return "viscous";
    case Damper::flat:
      return "flat";
    case Damper::thermoelastic:
      return "thermoelastic";
  }
  throw InputError("no such damper");
}

dem::Fiber metal_wire(const MetalValues& metal, double diameter, int aspect_ratio) {
  return {dem::isotropic_material(metal.youngs_modulus, metal.poisson_ratio, metal.density), diameter,
          aspect_ratio};
}

dem::Fiber with_flat_loss(const dem::Fiber& elastic, double loss_factor, dem::FrequencyBand band,
                          double frequency) {
  dem::MaterialDamping damping;
  damping.loss_factor = loss_factor, damping.band = band, damping.modulus_frequency = frequency;
  return dem::with_damping(elastic, damping).fiber;
}

dem::Fiber with_thermoelasticity(const dem::Fiber& elastic, const MetalValues& metal, double highest) {
  dem::MaterialDamping damping;
  damping.thermoelastic = metal.thermal, damping.highest_frequency = highest;
  return dem::with_damping(elastic, damping).fiber;
}

dem::Fiber with_viscous_damping(const dem::Fiber& elastic, double damping) {
  dem::Fiber fiber = elastic;
  fiber.bond_damping = 1;
  // zeta is proportional to xi_b up to its square
  for (int i = 0; i < 20; ++i)
    fiber.bond_damping *= damping / bending_modes_of(fiber, 1).front().decay.damping;
  return fiber;
}

reference::ThermoelasticWire reference_wire(const MetalValues& metal, double diameter) {
  return {.radius = diameter / 2,
          .modulus = metal.youngs_modulus,
          .expansion = metal.thermal.expansion,
          .temperature = metal.thermal.temperature,
          .density = metal.density,
          .specific_heat = metal.thermal.heat_capacity,
          .conductivity = metal.thermal.conductivity};
}

std::vector<reference::ComplexChainMode> exact_thermoelastic_modes(const dem::Fiber& elastic,
                                                                   const MetalValues& metal, int count) {
  const auto spring = reference::elastic_modulus();
  const auto bending = reference::thermoelastic_modulus(reference_wire(metal, elastic.diameter));
  return reference::complex_chain_modes(linear_chain_of(elastic), {spring, spring, spring, bending},
                                        reference::ChainMotion::bending, reference::ChainEnds::clamped_free,
                                        count);
}

double first_frequency(const dem::Fiber& elastic) {
  return reference::first_bending_mode(linear_chain_of(elastic)).frequency / (2 * std::numbers::pi);
}

double diameter_at_peak(const MetalValues& metal, int aspect_ratio, double ratio) {
  const double d = 1e-3;  // f_1 goes as 1/d, the peak as 1/d^2
  const double peak = dem::thermal_peak(dem::thermal_diffusivity(metal.thermal, metal.density), d / 2);
  return d * ratio * peak / first_frequency(metal_wire(metal, d, aspect_ratio));
}

const dem::Fiber& ThreeFibers::of(Damper damper) const {
  return damper == Damper::viscous ? viscous : damper == Damper::flat ? flat : thermoelastic;
}

ThreeFibers three_fibers(const MetalValues& metal, int aspect_ratio) {
  const double diameter = diameter_at_peak(metal, aspect_ratio);
  const dem::Fiber elastic = metal_wire(metal, diameter, aspect_ratio);
  const double f = first_frequency(elastic);
  const dem::Fiber wire = with_thermoelasticity(elastic, metal, 100 * f);
  const double damping = bending_modes_of(wire, 1).front().decay.damping;
  ThreeFibers fibers{metal, diameter, elastic, {f / 3, f / 3 * 1e3}, elastic, elastic, wire};
  double loss = 2 * damping;
  for (int i = 0; i < 4; ++i) {
    fibers.flat = with_flat_loss(elastic, loss, fibers.band, f);
    loss *= damping / bending_modes_of(fibers.flat, 1).front().decay.damping;
  }
  fibers.viscous = with_viscous_damping(elastic, damping);
  return fibers;
}

ThreeFibers with_loss_factor(const ThreeFibers& fibers, double loss_factor) {
  ThreeFibers lossy = fibers;
  lossy.thermoelastic = fibers.elastic;
  lossy.flat = with_flat_loss(fibers.elastic, loss_factor, fibers.band, first_frequency(fibers.elastic));
  lossy.viscous = with_viscous_damping(fibers.elastic, bending_modes_of(lossy.flat, 1).front().decay.damping);
  return lossy;
}

}  // namespace fiberchain::compare
