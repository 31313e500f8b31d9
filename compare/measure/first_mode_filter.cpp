#include "compare/measure/first_mode_filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

using std::numbers::pi;

/// Weights of samples -reach ... reach about the middle one; of a cosine of that frequency they give back the
/// middle value, of one far from it nothing.
std::vector<double> weights_at(int reach, double angle_per_sample) {
  std::vector<double> weights;
  double gain = 0;
  for (int j = -reach; j <= reach; ++j) {
    const double window = std::pow(std::cos(pi * j / (2.0 * (reach + 1))), 8),
                 wave = std::cos(angle_per_sample * j);
    weights.push_back(window * wave);
    gain += weights.back() * wave;
  }
  for (double& weight : weights) weight /= gain;
  return weights;
}

/// The same for a frequency and three times it: a large swing has both.
std::vector<double> filter_weights(int reach, double angle_per_sample) {
  std::vector<double> weights = weights_at(reach, angle_per_sample);
  const std::vector<double> third = weights_at(reach, 3 * angle_per_sample);
  std::ranges::transform(weights, third, weights.begin(), std::plus{});
  return weights;
}

double weighted_sum(const std::vector<double>& weights, const double* first) {
  double sum = 0;
  for (std::size_t j = 0; j < weights.size(); ++j) sum += weights[j] * first[j];
  return sum;
}

}  // namespace

TipHistory first_mode_part(const TipHistory& history, double frequency) {
  const double period = 2 * pi / frequency,
               span = history.time.empty() ? 0.0 : history.time.back() - history.time.front();
  if (!(span >= 8 * period)) {
    throw InputError(fmt::format("a motion of {:.2f} periods is too short to part its modes", span / period));
  }
  const double interval = span / static_cast<double>(history.time.size() - 1);
  const int reach = static_cast<int>(std::lround(filter_reach * period / interval));
  const std::vector<double> weights = filter_weights(reach, frequency * interval);
  TipHistory part;
  for (std::size_t i = 0; i + weights.size() <= history.time.size(); ++i) {
    const double time = history.time[i + reach];
    if (time < history.time.front() + (filter_reach + 0.5) * period) continue;
    part.time.push_back(time);
    part.y.push_back(weighted_sum(weights, &history.y[i]));
    part.velocity.push_back(weighted_sum(weights, &history.velocity[i]));
  }
  return part;
}

}  // namespace fiberchain::compare
