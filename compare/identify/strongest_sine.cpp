#include <gsl/gsl_fft_real.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "compare/identify/damped_sines.hpp"

// Where a fit begins.
namespace fiberchain::compare {
namespace {

/// Samples that the grid of frequencies and decays looks at, at most.
constexpr std::size_t kGridSamples = 4000;

/// The record at even times, mean taken off, zeros behind: twice as many, a power of two.
std::vector<double> padded(const RingDownRecord& record, double mean) {
  const std::size_t n = record.time.size();
  std::size_t size = 2;
  while (size < 2 * n) size *= 2;
  std::vector<double> all(size, 0);
  const double from = record.time.front(),
               interval = (record.time.back() - from) / static_cast<double>(n - 1);
  for (std::size_t i = 0, at = 0; i < n; ++i) {
    const double t = from + static_cast<double>(i) * interval;
    while (at + 2 < n && record.time[at + 1] < t) ++at;
    const double part = (t - record.time[at]) / (record.time[at + 1] - record.time[at]);
    all[i] = std::lerp(record.displacement[at], record.displacement[at + 1], part) - mean;
  }
  return all;
}

/// Highest peak of the spectrum below a frequency, and the spacing of its lines [rad/s].
struct SpectralPeak {
  double frequency, spacing;
};

SpectralPeak spectral_peak(const RingDownRecord& record, double mean, double highest) {
  std::vector<double> all = padded(record, mean);
  const std::size_t size = all.size();
  gsl_fft_real_radix2_transform(all.data(), 1, size);
  const double interval =
                   (record.time.back() - record.time.front()) / static_cast<double>(record.time.size() - 1),
               spacing = 2 * std::numbers::pi / (interval * static_cast<double>(size));
  std::size_t best = 1;
  double most = -1;
  for (std::size_t k = 1; k < size / 2 && static_cast<double>(k) * spacing < highest; ++k) {
    const double power = all[k] * all[k] + all[size - k] * all[size - k];
    if (power > most) most = power, best = k;
  }
  return {static_cast<double>(best) * spacing, spacing};
}

/// Every so many-th sample.
RingDownRecord thinned(const RingDownRecord& record, double frequency) {
  const double samples_of_period = 2 * nyquist_frequency(record) / frequency;
  const auto most = static_cast<std::size_t>(std::max(1.0, samples_of_period / 8)),
             wanted = 1 + record.time.size() / kGridSamples, stride = std::min(most, wanted);
  if (stride == 1) return record;
  RingDownRecord all;
  for (std::size_t i = 0; i < record.time.size(); i += stride)
    all.time.push_back(record.time[i]), all.displacement.push_back(record.displacement[i]);
  return all;
}

/// The best offset and amplitudes of a sine of this decay and frequency, and what they leave.
struct Trial {
  DampedSine sine{};
  double squares = 0;
};

Trial best_of(const RingDownRecord& record, double s, double w) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0;
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const double t = record.time[i] - record.time[0], decay = std::exp(-s * t), y = record.displacement[i];
    const Eigen::Vector3d column(1, decay * std::cos(w * t), decay * std::sin(w * t));
    normal += column * column.transpose();
    right += y * column;
    squares += y * y;
  }
  const Eigen::Vector3d found = normal.ldlt().solve(right);
  return {{found[1], found[2], s, w}, squares - found.dot(right)};
}

}  // namespace

DampedSine strongest_sine(const RingDownRecord& record, double highest) {
  const double mean = std::reduce(record.displacement.begin(), record.displacement.end()) /
                      static_cast<double>(record.displacement.size());
  const SpectralPeak peak = spectral_peak(record, mean, highest);
  const RingDownRecord seen = thinned(record, peak.frequency);
  const double duration = record.time.back() - record.time.front();
  Trial best{{}, std::numeric_limits<double>::infinity()};
  const auto try_it = [&](double s, double w) {
    if (!(w > 0) || w >= highest) return;
    const Trial trial = best_of(seen, s, w);
    if (std::isfinite(trial.squares) && trial.squares < best.squares) best = trial;
  };
  // decays from a record that shows none to one over the radian
  for (double s = 0.05 / duration; s < peak.frequency; s *= 2) {
    for (int k = -4; k <= 4; ++k) try_it(s, peak.frequency + 0.5 * k * peak.spacing);
    for (const double part : {0.7, 0.85, 1.15, 1.3})
      if (s > 0.05 * peak.frequency) try_it(s, part * peak.frequency);
  }
  try_it(0, peak.frequency);
  return best.sine;
}

}  // namespace fiberchain::compare
