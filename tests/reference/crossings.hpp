#pragma once

#include <vector>

#include "reference/beam_history.hpp"

namespace reference_test {

/// Time at which y, a cubic through values and rates at both ends, falls through zero between a and b.
inline double zero_between(const fiberchain::reference::BeamSample& a,
                           const fiberchain::reference::BeamSample& b) {
  const double h = b.time - a.time;
  double u = a.y / (a.y - b.y);
  for (int i = 0; i < 20; ++i) {
    const double w = 1 - u;
    const double y = (1 + 2 * u) * w * w * a.y + u * w * w * h * a.y_rate + u * u * (3 - 2 * u) * b.y -
                     u * u * w * h * b.y_rate;
    u -= y / (h * (a.y_rate * w + b.y_rate * u));
  }
  return a.time + u * h;
}

/// Mean period: slope of a straight line fitted to the times of the falling zeros.
inline double mean_period(const std::vector<fiberchain::reference::BeamSample>& samples) {
  std::vector<double> zeros;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    if (samples[i].y > 0 && samples[i + 1].y <= 0) zeros.push_back(zero_between(samples[i], samples[i + 1]));
  }
  const double n = static_cast<double>(zeros.size());
  double numerator = 0;
  double denominator = 0;
  for (std::size_t k = 0; k < zeros.size(); ++k) {
    const double offset = static_cast<double>(k) - (n - 1) / 2;
    numerator += offset * zeros[k];
    denominator += offset * offset;
  }
  return numerator / denominator;
}

}  // namespace reference_test
