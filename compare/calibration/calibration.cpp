#include "compare/calibration/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/study/errors.hpp"
#include "dem/motion/time_step.hpp"
#include "reference/damped_beam.hpp"
#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"

namespace fiberchain::compare {
namespace {

constexpr int largest_aspect_ratio = 1000;
constexpr double smallest_decay = 1e-13;  // xi_f omega dt, of which a double resolves 2e-16

bool is_retarded(const dem::Fiber& fiber) { return fiber.dashpots == dem::DashpotLaw::retardation_time; }

std::string setting_name(const dem::Fiber& fiber) {
  return is_retarded(fiber) ? "retardation time over t_b" : "bond damping";
}

dem::Fiber with_setting(dem::Fiber fiber, double setting) {
  fiber.bond_damping = is_retarded(fiber) ? 0 : setting;
  fiber.retardation_time = is_retarded(fiber) ? setting * dem::bond_time_step(fiber) : 0;
  return fiber;
}

double setting_of(const dem::Fiber& fiber) {
  return is_retarded(fiber) ? fiber.retardation_time / dem::bond_time_step(fiber) : fiber.bond_damping;
}

/// xi_f of a chain; 1 where the first mode does not oscillate, or is too close to that to be told from its
/// conjugate.
double first_damping(const reference::LinearChain& chain) {
  try {
    return reference::first_bending_mode(chain).damping;
  } catch (const reference::NoConvergence&) {
    return 1;
  }
}

/// Retardation time over t_b that gives a uniform beam this damping ratio; xi_b = 1 is tau = sqrt(16/5) t_b.
double guess(const dem::Fiber& fiber, double damping_ratio) {
  const double beta = reference::clamped_free_beta(1);
  const double retardation =
      8 * std::pow((dem::slenderness(fiber) + 0.5) / beta, 2) * damping_ratio / fiber.spacing;
  return is_retarded(fiber) ? retardation : retardation / std::sqrt(3.2);
}

double solved_setting(const dem::Fiber& fiber, double wanted) {
  const auto damping = [&](double setting) {
    return first_damping(linear_chain_of(with_setting(fiber, setting)));
  };
  const auto off = [&](double setting) { return damping(setting) / wanted - 1; };
  double found = guess(fiber, wanted);
  const double low = found / 3, high = found * 3;
  for (int i = 0; i < 5; ++i) {  // xi_f is nearly proportional to the setting
    const double more = off(found);
    if (std::abs(more) <= 1e-13) return found;
    found /= 1 + more;
  }
  if (off(high) > 0 && off(low) < 0) {
    found = reference::detail::find_root(off, low, high, {}, "setting of the dashpots");
    if (std::abs(off(found)) <= 1e-10) return found;
  }
  throw InputError(
      fmt::format("xi_f = {:g} cannot be reached at aspect ratio {} with dashpots set by {}: its first mode "
                  "is overdamped before",
                  wanted, dem::slenderness(fiber), dem::name(fiber.dashpots)));
}

/// The chain whose bonds cannot shear.
reference::LinearChain unsheared(reference::LinearChain chain) {
  chain.stiffness.shear *= 1e8;
  chain.dashpot.shear *= 1e4;
  return chain;
}

/// Frequency of a uniform beam of the chain's mass over that of the fiber.
double lightness(const dem::Fiber& fiber) {
  dem::Fiber own = fiber;
  own.mass = dem::MassModel::cylinder;
  return std::sqrt(dem::sphere_mass(own) / dem::sphere_mass(fiber));
}

/// In the order in which the causes are let in: the chain's mass, finite bonds, then shear.
BeamDeparture departure(double beam, double lightness, double without_shear, double chain) {
  return {lightness - 1, without_shear / beam - lightness, (chain - without_shear) / beam};
}

double undamped_frequency(reference::LinearChain chain) {
  chain.dashpot = {};
  return reference::first_bending_mode(chain).frequency;
}

double beam_frequency(const dem::Fiber& fiber) {
  const double mu = dem::sphere_mass(fiber) / dem::bond_length(fiber), L = dem::fiber_length(fiber);
  return std::pow(reference::clamped_free_beta(1) / L, 2) * std::sqrt(dem::bending_stiffness(fiber) / mu) /
         lightness(fiber);
}

void check(const CalibrationCase& asked) {
  dem::check(asked.fiber);
  if (asked.fiber.aspect_ratio > largest_aspect_ratio) {
    throw InputError(fmt::format("aspect ratio {} is not allowed: at most {}", asked.fiber.aspect_ratio,
                                 largest_aspect_ratio));
  }
  to_amplitude(AmplitudeMeasure::tip_deflection, asked.amplitude);
}

/// dt as dem::ring_down takes it, before it is fitted to the samples.
double step_of(const CalibrationCase& asked, double bond_time, double stable) {
  if (!asked.step_ratio) return std::min(0.25 * bond_time, 0.8 * stable);
  const double step = *asked.step_ratio * bond_time;
  if (!(step > 0) || step >= stable) {
    throw InputError(
        fmt::format("step ratio {} is not allowed: above 0 and below {:.4g}, the largest stable step of this "
                    "chain over t_b",
                    *asked.step_ratio, stable / bond_time));
  }
  return step;
}

/// A step whose decay is lost in the rounding of a double is no step of a run.
void check_resolved(const Calibration& found) {
  const double decay = found.damping_ratio * found.natural_frequency * found.step;
  if (decay >= smallest_decay) return;
  throw InputError(
      fmt::format("step ratio {:g} is not allowed: the motion decays by {:.1e} of itself in such a step, "
                  "less than the {:g} "
                  "that a double resolves with some digits; above {:.2g} it does",
                  found.step / found.bond_time, decay, smallest_decay,
                  smallest_decay / decay * found.step / found.bond_time));
}

/// All that is said of a fiber whose dashpots are set.
Calibration described(const CalibrationCase& asked, const dem::Fiber& fiber) {
  const reference::LinearChain chain = linear_chain_of(fiber);
  Calibration found{};
  found.fiber = fiber;
  found.mode = reference::first_bending_mode(chain);
  found.damping_ratio = found.mode.damping;
  found.setting = setting_of(fiber);
  found.retardation_time = chain.dashpot.bend / chain.stiffness.bend;
  found.natural_frequency = found.mode.frequency;
  found.stable_step = dem::stable_time_step(fiber);
  found.bond_time = dem::bond_time_step(fiber);
  found.step = step_of(asked, found.bond_time, found.stable_step);
  check_resolved(found);
  found.beam_frequency = beam_frequency(fiber);
  found.beam_damping = found.retardation_time * found.beam_frequency / 2;
  const double light = lightness(fiber);
  found.damping_departure =
      departure(found.beam_damping, light, first_damping(unsheared(chain)), found.damping_ratio);
  found.frequency_departure =
      departure(found.beam_frequency, light, undamped_frequency(unsheared(chain)), undamped_frequency(chain));
  found.amplitude_effect = amplitude_effect(asked.amplitude);
  found.time_step_effect = time_step_effect(found.damping_ratio, found.natural_frequency, found.step);
  return found;
}

}  // namespace

Calibration calibrate(const CalibrationCase& asked, double wanted) {
  to_damping_ratio(DampingMeasure::damping_ratio, wanted);
  const CalibrationCase unset{with_setting(asked.fiber, 0), asked.amplitude, asked.step_ratio};
  check(unset);
  return described(asked, with_setting(asked.fiber, solved_setting(unset.fiber, wanted)));
}

Calibration calibration_of(const CalibrationCase& asked) {
  check(asked);
  if (!dem::damped(asked.fiber))
    throw InputError("without damping of the bonds the fiber has none: nothing to calibrate");
  const double damping = first_damping(linear_chain_of(asked.fiber));
  if (!(damping < 1)) {
    throw InputError(
        fmt::format("{} = {:g} overdamps the first mode at aspect ratio {}: it has no xi_f below 1",
                    setting_name(asked.fiber), setting_of(asked.fiber), asked.fiber.aspect_ratio));
  }
  return described(asked, asked.fiber);
}

}  // namespace fiberchain::compare
