#include "dem/material/equal_ripple.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

double log_error(const RippledSeries& fit, const LossTarget& target, double log_omega) {
  const double omega = std::exp(log_omega);
  return std::log(loss_factor(fit.series, omega) / loss_factor(target, omega));
}

/// ln(1 + e) above and ln(1 - e) below the target for a ripple e = tanh(half), which stays below 1.
double level(bool above, double half) {
  return std::numbers::ln2 - std::log1p(std::exp(above ? -2 * half : 2 * half));
}

double level_slope(bool above, double half) {
  return above ? 2 / (1 + std::exp(2 * half)) : -2 / (1 + std::exp(-2 * half));
}

/// d ln(tan delta) / d(ln g_j, ln tau_j) for all branches.
void fill_row(const PronySeries& series, double omega, Eigen::MatrixXd& A, Eigen::Index row) {
  const std::complex<double> K = complex_modulus(series, {0, omega});
  for (std::size_t j = 0; j < series.size(); ++j) {
    const double x = omega * series[j].time, rest = 1 / (1 + x * x), g = series[j].strength;
    A(row, 2 * j) = g * x * rest * (1 / K.imag() - x / K.real());
    A(row, 2 * j + 1) = g * x * rest * rest * ((1 - x * x) / K.imag() - 2 * x / K.real());
  }
}

/// Longest component of Newton's step, of which a part is taken that changes no strength or time by more than
/// e.
double newton_step(RippledSeries& fit, const LossTarget& target, double& half) {
  const Eigen::Index unknowns = static_cast<Eigen::Index>(fit.extremes.size());
  Eigen::MatrixXd A(unknowns, unknowns);
  Eigen::VectorXd b(unknowns);
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    const double omega = fit.extremes[i];
    const bool above = i % 2 == 1;
    fill_row(fit.series, omega, A, i);
    A(i, unknowns - 1) = -level_slope(above, half);
    b[i] = level(above, half) - log_error(fit, target, std::log(omega));
  }
  const Eigen::VectorXd step = A.partialPivLu().solve(b);
  const double longest = step.cwiseAbs().maxCoeff(), part = std::min(1.0, 1 / longest);
  for (std::size_t j = 0; j < fit.series.size(); ++j) {
    fit.series[j].strength *= std::exp(part * step[2 * j]);
    fit.series[j].time *= std::exp(part * step[2 * j + 1]);
  }
  half += part * step[unknowns - 1];
  return longest;
}

/// The same error at all of the present extremes.
void level_extremes(RippledSeries& fit, const LossTarget& target, double& half) {
  constexpr int most_steps = 60;
  double longest = 1, before = 2;
  for (int i = 0; i < most_steps; ++i) {
    longest = newton_step(fit, target, half);
    // Round-off is what is left where a step of a quadratic method is no shorter than a small one before.
    if (longest < 1e-12 || (longest < 1e-5 && longest > 0.5 * before)) return;
    if (!std::isfinite(longest)) break;
    before = longest;
  }
  throw NoConvergence(
      fmt::format("Maxwell branches: no equal ripple of {} branches found", fit.series.size()));
}

struct Sample {
  double place, error;
};

/// Vertex of the parabola through three samples, within them.
double vertex(const Sample& a, const Sample& b, const Sample& c) {
  const double left = (b.error - a.error) / (b.place - a.place);
  const double right = (c.error - b.error) / (c.place - b.place);
  if (left == right) return b.place;
  const double bend = (right - left) / (c.place - a.place);
  return std::clamp((a.place + b.place) / 2 - left / (2 * bend), a.place, c.place);
}

/// The extreme that the middle one of three samples is nearest to, by parabolas.
Sample refined(const RippledSeries& fit, const LossTarget& target, Sample a, Sample b, Sample c) {
  constexpr int times = 4;
  for (int i = 0; i < times; ++i) {
    const double place = vertex(a, b, c);
    if (place == a.place || place == b.place || place == c.place) break;
    const Sample sample{place, log_error(fit, target, place)};
    const bool better = std::abs(sample.error) > std::abs(b.error);
    Sample& outer = (place < b.place) == better ? c : a;
    outer = better ? b : sample;
    if (better) b = sample;
  }
  return b;
}

std::vector<Sample> sampled(const RippledSeries& fit, const LossTarget& target) {
  constexpr int parts = 12;
  std::vector<Sample> samples;
  for (std::size_t i = 0; i + 1 < fit.extremes.size(); ++i) {
    const double low = std::log(fit.extremes[i]), high = std::log(fit.extremes[i + 1]);
    for (int k = 0; k < parts; ++k) samples.push_back({low + k * (high - low) / parts, 0});
  }
  samples.push_back({std::log(fit.extremes.back()), 0});
  for (Sample& sample : samples) sample.error = log_error(fit, target, sample.place);
  return samples;
}

/// The extreme of the samples from one change of sign to the next that holds sample `i`.
std::size_t extreme_around(const std::vector<Sample>& samples, std::size_t i) {
  const double sign = samples[i].error;
  std::size_t found = i;
  for (const int way : {-1, 1}) {
    for (std::size_t k = i; k < samples.size() && samples[k].error * sign > 0; k += way) {
      if (std::abs(samples[k].error) > std::abs(samples[found].error)) found = k;
    }
  }
  return found;
}

/// Moves the extremes to where the error is extreme now; the largest and the least of them, as ripples.
std::pair<double, double> exchange(RippledSeries& fit, const LossTarget& target) {
  const std::vector<Sample> samples = sampled(fit, target);
  const std::size_t parts = (samples.size() - 1) / (fit.extremes.size() - 1);
  double largest = 0, least = 1;
  for (std::size_t i = 0; i < fit.extremes.size(); ++i) {
    const std::size_t k = extreme_around(samples, i * parts);
    Sample extreme = samples[k];
    if (k > 0 && k + 1 < samples.size()) {
      extreme = refined(fit, target, samples[k - 1], samples[k], samples[k + 1]);
    }
    const bool end = i == 0 || i + 1 == fit.extremes.size();
    if (!end) fit.extremes[i] = std::exp(extreme.place);
    const double error = std::abs(std::expm1(extreme.error));
    largest = std::max(largest, error);
    least = std::min(least, error);
  }
  return {largest, least};
}

}  // namespace

double loss_factor(const LossTarget& target, double omega) {
  return target.series.empty() ? target.flat : loss_factor(target.series, omega);
}

RippledSeries equal_ripple(RippledSeries start, const LossTarget& target) {
  constexpr int most_exchanges = 30;
  constexpr double equal = 1e-6;
  double half = std::atanh(start.ripple);
  for (int i = 0; i < most_exchanges; ++i) {
    level_extremes(start, target, half);
    const auto [largest, least] = exchange(start, target);
    start.ripple = largest;
    if (largest - least <= equal * largest + 1e-14) return start;
  }
  throw NoConvergence(
      fmt::format("Maxwell branches: no equal ripple of {} branches found", start.series.size()));
}

}  // namespace fiberchain::dem
