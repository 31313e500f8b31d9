#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/calibration/calibration.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/study/errors.hpp"

// The calibrated chain, marched.
namespace fiberchain::compare {
namespace {

constexpr double amount = 1.0 / 300;  // y / L: changes xi_f by 5e-6 of itself

/// Four, or fewer where the fourth would be lost in the rounding of the first.
int peaks_of(const Calibration& found) {
  return std::clamp(1 + static_cast<int>(12 / log_decrement(found.damping_ratio)), 2, 4);
}

/// The first comes a little before the end of the first period.
double periodic_box(const Calibration& found) { return peaks_of(found) + 0.2; }

double steps_per_period(const Calibration& found) {
  const double period = 2 * std::numbers::pi / std::abs(found.mode.eigenvalue.imag());
  const double samples = dem::ReleaseOptions{}.samples_per_period;
  return samples * std::ceil(period / (samples * found.step) * (1 - 1e-12));
}

}  // namespace

double verification_cost(const Calibration& found) {
  return periodic_box(found) * steps_per_period(found) * found.fiber.aspect_ratio;
}

Verification verify(const Calibration& found) {
  const double cost = verification_cost(found);
  if (cost > largest_verification) {
    throw InputError(fmt::format(
        "the run that verifies this would take {:.2g} bond-steps (aspect ratio {}, {:.2g} steps a "
        "period at {:.3g} t_b), {:g} are allowed: leave --verify out",
        cost, found.fiber.aspect_ratio, steps_per_period(found), found.step / found.bond_time,
        largest_verification));
  }
  dem::ReleaseOptions options;
  options.step_ratio = found.step / found.bond_time;
  const auto record =
      dem::ring_down<2>({mode_release(found.fiber, found.mode, amount, periodic_box(found))}, options)
          .front();
  const TipHistory history = tip_history(record, dem::fiber_length(found.fiber));
  const double measured = damping_from_peaks(positive_peaks(history), {0, peaks_of(found) - 1}).ratio;
  return {measured, measured / found.damping_ratio - 1, record.time_step,
          record.steps * found.fiber.aspect_ratio};
}

}  // namespace fiberchain::compare
