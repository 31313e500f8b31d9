#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

/// Largest magnitudes of a function between its changes of sign along a logarithmic grid, one of each
/// stretch.
inline std::vector<double> alternating_extremes(const std::function<double(double)>& error, double low,
                                                double high, int points) {
  std::vector<double> extremes;
  double before = 0;
  for (int i = 0; i <= points; ++i) {
    const double e = error(low * std::pow(high / low, static_cast<double>(i) / points));
    if (extremes.empty() || e * before < 0) extremes.push_back(0);
    extremes.back() = std::max(extremes.back(), std::abs(e));
    before = e;
  }
  return extremes;
}
