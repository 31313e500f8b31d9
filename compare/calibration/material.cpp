#include "compare/calibration/material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/measure/bond_spectra_of.hpp"
#include "compare/study/errors.hpp"
#include "dem/motion/time_step.hpp"
#include "reference/complex_modes.hpp"
#include "reference/damped_beam.hpp"
#include "reference/errors.hpp"
#include "reference/thermoelastic.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

constexpr int largest_aspect_ratio = 300;

bool damps(const dem::MaterialDamping& damping) {
  return damping.loss_factor || damping.shear_loss_factor || damping.thermoelastic ||
         !damping.spectrum.youngs_modulus.empty() || !damping.spectrum.bending.empty();
}

dem::Fiber with_own_mass(dem::Fiber fiber) {
  fiber.mass = dem::MassModel::cylinder;
  return fiber;
}

/// Frequency of a mode of the elastic uniform beam of the fiber's own mass [Hz].
double beam_frequency(const dem::Fiber& fiber, int mode) {
  const double mass = dem::sphere_mass(with_own_mass(fiber)) / dem::bond_length(fiber);
  return std::pow(reference::clamped_free_beta(mode) / dem::fiber_length(fiber), 2) *
         std::sqrt(dem::bending_stiffness(fiber) / mass) / (2 * pi);
}

void choose_band(MaterialCase& asked) {
  const bool flat = asked.damping.loss_factor || asked.damping.shear_loss_factor;
  if (!flat || asked.damping.band) return;
  asked.band_of_modes = true;
  asked.damping.band =
      dem::FrequencyBand{beam_frequency(asked.fiber, 1) / 3, 3 * beam_frequency(asked.fiber, material_modes)};
}

/// What thermoelasticity adds to k(s), exactly.
reference::ComplexModulus thermal_part(const MaterialAnswer& answer) {
  const dem::Fiber& fiber = answer.asked.fiber;
  const dem::ThermalProperties& thermal = *answer.asked.damping.thermoelastic;
  const auto exact = reference::thermoelastic_modulus({.radius = dem::sphere_radius(fiber),
                                                       .modulus = fiber.material.youngs_modulus,
                                                       .expansion = thermal.expansion,
                                                       .temperature = thermal.temperature,
                                                       .density = fiber.material.density,
                                                       .specific_heat = thermal.heat_capacity,
                                                       .conductivity = thermal.conductivity});
  const double over_relaxed = 1 / answer.damped.summary.relaxed_part;
  return [exact, over_relaxed](std::complex<double> s) {
    const reference::ModulusValue k = exact(s);
    return reference::ModulusValue{over_relaxed * (k.value - 1.0), over_relaxed * k.slope};
  };
}

/// Bending of the fiber as a continuum: its parts and their sum.
struct Continuum {
  reference::ComplexModulus flat, thermal, all;
};

Continuum continuum_of(const MaterialAnswer& answer) {
  Continuum parts;
  const auto& relaxation = answer.damped.summary.relaxation;
  const bool thermal = answer.asked.damping.thermoelastic.has_value();
  dem::PronySeries flat = relaxation.youngs_modulus;
  const dem::PronySeries& given = answer.asked.damping.spectrum.bending;
  flat.insert(flat.end(), given.begin(), given.end());
  parts.flat = reference::complex_modulus(prony_terms(flat));
  parts.thermal = thermal ? thermal_part(answer) : [](std::complex<double>) {
    return reference::ModulusValue{0, 0};
  };
  parts.all = [flat = parts.flat, thermal = parts.thermal](std::complex<double> s) {
    const reference::ModulusValue a = flat(s), b = thermal(s);
    return reference::ModulusValue{a.value + b.value, a.slope + b.slope};
  };
  return parts;
}

std::optional<double> ripple_of(const MaterialAnswer& answer, const MaterialMode& mode) {
  const auto& band = answer.asked.damping.band;
  if (answer.damped.summary.ripple == 0) return 0.0;
  if (mode.frequency < band->low || mode.frequency > band->high) return std::nullopt;
  const double all = mode.flat_part + mode.thermoelastic_part;
  return all > 0 ? answer.damped.summary.ripple * mode.flat_part / all : 0.0;
}

std::vector<MaterialMode> modes_of(const MaterialAnswer& answer) {
  const dem::Fiber& fiber = answer.damped.fiber;
  const int count = std::min(material_modes, fiber.aspect_ratio);
  const Continuum continuum = continuum_of(answer);
  const double mass = dem::sphere_mass(with_own_mass(fiber)) / dem::bond_length(fiber);
  const auto beam =
      reference::complex_beam_modes({dem::fiber_length(fiber), dem::bending_stiffness(fiber), mass},
                                    continuum.all, reference::ChainEnds::clamped_free, count);
  const auto chain = bending_modes_of(fiber, count);
  std::vector<MaterialMode> modes;
  for (int n = 0; n < count; ++n) {
    const reference::FreeDecay& decay = chain[static_cast<std::size_t>(n)].decay;
    const std::complex<double> s(0, decay.frequency);
    const double storage = continuum.all(s).value.real();
    MaterialMode mode{.number = n + 1,
                      .frequency = decay.frequency / (2 * pi),
                      .damping = decay.damping,
                      .beam_damping = beam[static_cast<std::size_t>(n)].decay.damping,
                      .ripple = {},
                      .flat_part = continuum.flat(s).value.imag() / storage / 2,
                      .thermoelastic_part = continuum.thermal(s).value.imag() / storage / 2};
    mode.ripple = ripple_of(answer, mode);
    modes.push_back(mode);
  }
  return modes;
}

/// Dashpots in place of the branches, for codes that have no others.
void find_dashpots(MaterialAnswer& answer) {
  try {
    answer.dashpots = calibrate({answer.asked.fiber}, answer.modes.front().damping);
    for (const auto& mode : bending_modes_of(answer.dashpots->fiber, static_cast<int>(answer.modes.size())))
      answer.dashpot_damping.push_back(mode.decay.damping);
  } catch (const InputError& error) {
    answer.no_dashpots = error.what();
  } catch (const reference::NoConvergence& error) {
    answer.no_dashpots = error.what();
  }
}

}  // namespace

MaterialAnswer answer_material(MaterialCase asked) {
  if (asked.fiber.aspect_ratio > largest_aspect_ratio) {
    throw InputError(fmt::format("aspect ratio {} is not allowed with a material: at most {}",
                                 asked.fiber.aspect_ratio, largest_aspect_ratio));
  }
  dem::check(asked.fiber);
  choose_band(asked);
  MaterialAnswer answer{.asked = asked, .damped = {asked.fiber, {}}, .modes = {}};
  if (damps(asked.damping)) {
    answer.damped = dem::with_damping(asked.fiber, asked.damping);
    answer.modes = modes_of(answer);
    find_dashpots(answer);
  } else {
    answer.no_dashpots = "no damping of the material is known";
  }
  answer.step = 0.8 * dem::stable_time_step(answer.damped.fiber);
  return answer;
}

}  // namespace fiberchain::compare
