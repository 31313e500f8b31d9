#include "dem/material/thermoelastic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "dem/material/equal_ripple.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

constexpr double first_root = 1.8411837813406593;

void require(bool holds, std::string_view name, double value, std::string_view allowed) {
  if (holds && std::isfinite(value)) return;
  throw InvalidInput(fmt::format("{} = {} is not allowed: it must be {}", name, value, allowed));
}

void require_positive(std::string_view name, double value) {
  require(value > 0, name, value, "finite and greater than 0");
}

/// k-th root of J_1', k = 1, 2, ...: McMahon's expansion (Abramowitz & Stegun, ch. 9), Newton's method on it
/// where that is not exact to round-off.
double root_of_bessel_slope(int k) {
  const double beta = (k - 0.25) * std::numbers::pi, b = 8 * beta;
  double q = beta - 7 / b - 1724 / (3 * b * b * b) - 956576 / (15 * std::pow(b, 5));
  constexpr int exact_from = 60;
  if (k == 1) q = first_root;
  for (int i = 0; k < exact_from && i < 4; ++i) {
    const double J1 = std::cyl_bessel_j(1, q), slope = std::cyl_bessel_j(0, q) - J1 / q;
    q += slope / (slope / q + (1 - 1 / (q * q)) * J1);
  }
  return q;
}

/// So many modes that what is left out changes no K'' by 1e-5 of itself: with tau = 1 / q^2 that is
/// sum 8 omega / q^6, near 8 omega / (5 pi q^5), of 4 / omega.
int modes_up_to(double over_peak) {
  const double omega = first_root * first_root * over_peak;
  const double q = std::pow(2 * omega * omega / (5 * std::numbers::pi * 1e-5), 0.2);
  return 12 + static_cast<int>(q / std::numbers::pi);
}

/// Modes beyond the twentieth in groups within 5 % of a root: their share is at most 1 % of the loss, what
/// grouping them changes 1e-5 of it.
PronySeries grouped(const PronySeries& modes) {
  constexpr std::size_t single = 20;
  PronySeries groups;
  for (std::size_t k = 0; k < modes.size();) {
    const std::size_t size = k < single ? 1 : k / single;
    MaxwellBranch group{0, 0};
    for (const std::size_t end = std::min(k + size, modes.size()); k < end; ++k) {
      group.strength += modes[k].strength;
      group.time += modes[k].strength * modes[k].time;
    }
    group.time /= group.strength;
    groups.push_back(group);
  }
  return groups;
}

/// The thermal modes are even in omega: extremes as Chebyshev's over a band from -high to high, in a variable
/// that is omega up to the first mode's rate and its logarithm beyond.
std::vector<double> first_extremes(double rate, double high, int branches) {
  constexpr double nearly_zero = 1e-4;
  std::vector<double> extremes{nearly_zero * std::min(rate, high)};
  const double end = std::asinh(high / rate);
  for (int i = 1; i < 2 * branches; ++i) {
    extremes.push_back(rate * std::sinh(end * std::sin(std::numbers::pi * i / (4 * branches))));
  }
  extremes.push_back(high);
  return extremes;
}

/// The first mode, and for the further ones, sum 8 / q^4 = 8 / (3 pi q^3), branches at places from the second
/// on to as many as there are, or to the highest frequency.
PronySeries first_branches(const PronySeries& modes, double high, int branches) {
  PronySeries series{modes.front()};
  const double second = 1 / modes[1].time, last = std::max(1 / modes[branches].time, high);
  const double ratio = std::pow(last / second, 1.0 / branches);
  for (int j = 1; j < branches; ++j) {
    const double rate = second * std::pow(ratio, j - 0.5);
    series.push_back({modes[1].strength * std::pow(rate / second, -1.5), 1 / rate});
  }
  return series;
}

}  // namespace

double relaxation_strength(const ThermalProperties& properties, double youngs_modulus, double density) {
  require(true, "expansion", properties.expansion, "finite");
  require_positive("temperature", properties.temperature);
  require_positive("heat capacity", properties.heat_capacity);
  require_positive("Young's modulus", youngs_modulus);
  require_positive("density", density);
  const double strength = youngs_modulus * properties.expansion * properties.expansion *
                          properties.temperature / (density * properties.heat_capacity);
  require(strength < 1, "E alpha^2 T / (rho c)", strength, "less than 1");
  return strength;
}

double thermal_diffusivity(const ThermalProperties& properties, double density) {
  require_positive("conductivity", properties.conductivity);
  require_positive("heat capacity", properties.heat_capacity);
  require_positive("density", density);
  return properties.conductivity / (density * properties.heat_capacity);
}

double thermal_peak(double diffusivity, double radius) {
  require_positive("diffusivity", diffusivity);
  require_positive("radius", radius);
  return first_root * first_root * diffusivity / (2 * std::numbers::pi * radius * radius);
}

PronySeries thermal_modes(double strength, double diffusivity, double radius, int count) {
  require(strength >= 0, "relaxation strength", strength, "finite and 0 or greater");
  require_positive("diffusivity", diffusivity);
  require_positive("radius", radius);
  require_positive("count", count);
  PronySeries modes;
  for (int k = 1; k <= count; ++k) {
    const double q = root_of_bessel_slope(k), square = q * q;
    modes.push_back({strength * 8 / (square * (square - 1)), radius * radius / (diffusivity * square)});
  }
  return modes;
}

PronySeries thermoelastic_branches(double strength, double diffusivity, double radius,
                                   double highest_frequency, double tolerance) {
  constexpr double farthest = 1e7, finest = 1e-3;
  constexpr int most_branches = 8;
  const double peak = thermal_peak(diffusivity, radius);
  require(strength >= 0 && strength <= 1, "relaxation strength", strength, "0 to 1");
  require_positive("highest frequency", highest_frequency);
  require(tolerance >= finest && tolerance <= 1, "tolerance", tolerance, "0.001 to 1");
  if (strength == 0) return {};
  const double over_peak = std::clamp(highest_frequency / peak, 1.0, farthest);
  const PronySeries modes = thermal_modes(strength, diffusivity, radius, modes_up_to(over_peak));
  const LossTarget target{grouped(modes), 0};
  const double rate = 2 * std::numbers::pi * peak, high = over_peak * rate;
  for (int n = 1; n <= most_branches; ++n) {
    const RippledSeries start{first_branches(modes, high, n), first_extremes(rate, high, n), 0.01};
    const RippledSeries fit = equal_ripple(start, target);
    if (fit.ripple <= tolerance) return fit.series;
  }
  throw NoConvergence("thermoelastic branches: none found within the tolerance");
}

}  // namespace fiberchain::dem
