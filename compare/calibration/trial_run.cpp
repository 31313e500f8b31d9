#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "compare/calibration/calibration.hpp"
#include "compare/measure/first_mode_damping.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/study/errors.hpp"
#include "reference/elastica.hpp"

// The calibrated chain, marched.
namespace fiberchain::compare {
namespace {

constexpr double vanishing = 1.0 / 300;  // y / L: changes xi_f by 5e-6 of itself

CleanPeaks peaks_of(const Calibration& found, double amplitude) {
  return amplitude > 0 ? clean_peaks(linear_chain_of(found.fiber), found.mode)
                       : mode_release_peaks(found.mode);
}

double steps_per_period(const Calibration& found) {
  const double period = 2 * std::numbers::pi / std::abs(found.mode.eigenvalue.imag());
  const double samples = dem::ReleaseOptions{}.samples_per_period;
  return samples * std::ceil(period / (samples * found.step) * (1 - 1e-12));
}

/// P L^2 / (E I) that bends the Elastica to y / L.
double load_of(double amplitude) {
  double low = 0, high = 3;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (reference::elastica_closed_form(middle).y < amplitude ? low : high) = middle;
  }
  return high;
}

dem::Release<2> release_of(const Calibration& found, double amplitude, double periods) {
  if (amplitude > 0) return static_release(found.fiber, found.mode, load_of(amplitude), periods);
  return mode_release(found.fiber, found.mode, vanishing, periods);
}

double root_mean_square(const std::vector<Peak>& peaks) {
  double squares = 0;
  for (const Peak& peak : peaks) squares += peak.value * peak.value;
  return std::sqrt(squares / static_cast<double>(peaks.size()));
}

/// xi_f of peaks that decay from the first one measured as those of the calibrated chain should at their
/// amplitudes, found as theirs is.
double expected_damping(const Calibration& found, const std::vector<Peak>& peaks) {
  std::vector<Peak> should{peaks.front()};
  for (std::size_t j = 1; j < peaks.size(); ++j) {
    const double middle = std::sqrt(peaks[j - 1].value * peaks[j].value);
    const double ratio = found.damping_ratio * (1 + amplitude_effect(middle));
    should.push_back({peaks[j].time, should.back().value * std::exp(-log_decrement(ratio))});
  }
  return damping_from_peaks(should, {0, static_cast<int>(should.size()) - 1}).ratio;
}

}  // namespace

double verification_cost(const Calibration& found, double amplitude) {
  return peaks_of(found, amplitude).periods() * steps_per_period(found) * found.fiber.aspect_ratio;
}

Verification verify(const Calibration& found, double amplitude) {
  const CleanPeaks clean = peaks_of(found, amplitude);
  if (clean.way == CleanPeaks::Way::none) {
    throw InputError(fmt::format(
        "xi_f = {:g} cannot be verified at an amplitude: higher modes outlive the first; leave --load and "
        "--tip-deflection or --verify out",
        found.damping_ratio));
  }
  const double cost = verification_cost(found, amplitude);
  if (cost > largest_verification) {
    throw InputError(fmt::format(
        "the run that verifies this would take {:.2g} bond-steps (aspect ratio {}, {:.2g} steps a "
        "period at {:.3g} t_b), {:g} are allowed: leave --verify out",
        cost, found.fiber.aspect_ratio, steps_per_period(found), found.step / found.bond_time,
        largest_verification));
  }
  dem::ReleaseOptions options;
  options.step_ratio = found.step / found.bond_time;
  const auto record = dem::ring_down<2>({release_of(found, amplitude, clean.periods())}, options).front();
  const TipHistory history = tip_history(record, dem::fiber_length(found.fiber));
  const FirstModeDamping measured = first_mode_damping(history, clean, found.mode.eigenvalue.imag());
  const double expected = amplitude > 0 ? expected_damping(found, measured.measured) : found.damping_ratio;
  return {measured.peaks.ratio,
          root_mean_square(measured.measured),
          expected,
          measured.peaks.ratio / expected - 1,
          record.time_step,
          record.steps * found.fiber.aspect_ratio};
}

}  // namespace fiberchain::compare
