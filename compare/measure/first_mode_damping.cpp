#include "compare/measure/first_mode_damping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compare/measure/first_mode_filter.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"

namespace fiberchain::compare {
namespace {

constexpr double start = 0.03;        // of the higher modes over the first: 1/39.3 of mode 2, less of others
constexpr double wanted = 1e-4;       // effect on xi_f in parts of it
constexpr double faster = 39.2738;    // (beta_2/beta_1)^4: decay of mode 2 over that of mode 1
constexpr int most_intervals = 5;     // between the peaks that are measured
constexpr int longest_wait = 15;      // first peak; later ones are of the filtered motion
constexpr int first_filtered = 4;     // the filter's first peak
constexpr double deepest_decay = 16;  // of ln y from the release to the last peak, of 36 in a double
constexpr double deep_decay = 4;      // of ln y to the last peak, from which the rest is looked at
constexpr double settled_decay = 12;  // of ln y from the last peak to rest
constexpr int dense_bonds = 30;       // up to which all modes are found

/// Slowest decay of another mode than the first [1/s]. Beyond dense_bonds a uniform beam's: overdamped modes
/// creep with half of |lambda_1|/xi_f at the least.
double slowest_other_decay(const reference::LinearChain& chain, const reference::ChainMode& mode) {
  if (chain.bonds > dense_bonds) {
    return std::min(0.98 * faster * mode.damping, 0.5 / mode.damping) * mode.frequency;
  }
  double slowest = std::numeric_limits<double>::infinity();
  for (const auto& other :
       reference::chain_modes(chain, reference::ChainMotion::bending, reference::ChainEnds::clamped_free)) {
    if (std::abs(other.eigenvalue - mode.eigenvalue) < 1e-6 * mode.frequency) continue;
    slowest = std::min(slowest, -other.eigenvalue.real());
  }
  return slowest;
}

/// Sum of the weights' sizes with which ln y of n + 1 peaks makes their slope.
double slope_weights(int n) {
  double sum = 0, squares = 0;
  for (int j = 0; j <= n; ++j) sum += std::abs(j - n / 2.0), squares += (j - n / 2.0) * (j - n / 2.0);
  return sum / squares;
}

}  // namespace

double CleanPeaks::periods() const {
  // a release from equilibrium begins on its peak 0, one from the first mode almost a period before it
  const double begin = way == Way::mode_release ? 1 : 0, end = way == Way::filter ? filter_reach : 0;
  return begin + range.last + std::max(end, settling) + 0.7;
}

CleanPeaks mode_release_peaks(const reference::ChainMode& mode) {
  const int last = static_cast<int>(0.6 * deepest_decay / log_decrement(mode.damping));
  return {CleanPeaks::Way::mode_release, {0, std::clamp(last, 1, 3)}};
}

CleanPeaks filtered_peaks(int intervals) {
  return {CleanPeaks::Way::filter, {first_filtered, first_filtered + intervals}};
}

CleanPeaks clean_peaks(const reference::LinearChain& chain, const reference::ChainMode& mode,
                       double most_periods) {
  const double delta = log_decrement(mode.damping);
  const double period = 2 * std::numbers::pi / mode.eigenvalue.imag();
  const double parting = slowest_other_decay(chain, mode) * period - delta;  // of ln of their ratio, a period
  const double last_seen = deepest_decay / delta;
  for (int n = most_intervals; n >= 1 && parting > 0; --n) {
    const double ratio = start * slope_weights(n) / (wanted * delta);
    const double first = std::max(1.0, std::ceil(std::log(ratio) / parting));
    if (first <= longest_wait && first + n <= last_seen) {
      const double settling = (first + n) * delta > deep_decay ? settled_decay / delta : 0;
      const CleanPeaks wait{
          CleanPeaks::Way::wait, {static_cast<int>(first), static_cast<int>(first) + n}, settling};
      if (wait.periods() <= most_periods) return wait;
    }
    const CleanPeaks filter = filtered_peaks(n);
    if (first > first_filtered && filter.periods() <= most_periods) return filter;
  }
  return {CleanPeaks::Way::none, {0, 0}};
}

FirstModeDamping first_mode_damping(const TipHistory& history, const CleanPeaks& clean, double frequency) {
  if (clean.way == CleanPeaks::Way::none) {
    throw InputError("higher modes outlive the first, which cannot be seen alone");
  }
  TipHistory motion = history;
  PeakRange range = clean.range;
  if (clean.way == CleanPeaks::Way::filter) {
    range = {0, range.last - range.first};
    // once more at the frequency found, where the filter is flat
    const Damping near = damping_from_peaks(positive_peaks(first_mode_part(history, frequency)), range);
    motion = first_mode_part(history, near.frequency);
  }
  if (clean.settling > 0) {
    const double rest = motion.y.back();
    for (double& y : motion.y) y -= rest;
  }
  const std::vector<Peak> peaks = positive_peaks(motion);
  FirstModeDamping found{damping_from_peaks(peaks, range), nan, {}};
  found.measured.assign(peaks.begin() + range.first, peaks.begin() + range.last + 1);
  try {
    found.sine =
        damping_from_sine(motion, peaks[range.first].time, peaks[range.last].time, found.peaks).ratio;
  } catch (const InputError&) {  // too few samples or no convergence: the peaks stand alone
  }
  return found;
}

}  // namespace fiberchain::compare
