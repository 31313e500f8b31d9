#include "dem/material/flat_loss.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "dem/material/zolotarev.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

void check(double value, FrequencyBand band) {
  if (!(value > 0 && value <= largest_flat_loss)) {
    throw InvalidInput(
        fmt::format("loss factor = {} is not allowed: it must be greater than 0 and at most {}", value,
                    largest_flat_loss));
  }
  const bool ordered = band.low > 0 && band.high > band.low && std::isfinite(band.high);
  if (!ordered || band.high / band.low > widest_flat_band) {
    throw InvalidInput(
        fmt::format("band = [{} Hz, {} Hz] is not allowed: its ends must be greater than 0, finite and "
                    "ascending, at most a factor of {:g} apart",
                    band.low, band.high, widest_flat_band));
  }
}

/// |x r(-x^2)| of the flat function x r(x^2) at x = root_i exp(u): infinite at the root, a pole of r.
double beyond(const FlatFunction& function, std::size_t i, double u) {
  const double root = function.roots[i], x = root * std::exp(u);
  double value = function.factor * x / (root * root * std::abs(std::expm1(2 * u)));
  for (std::size_t k = 0; k < function.roots.size(); ++k) {
    if (k == i) continue;
    const double other = function.roots[k], difference = std::abs((other - x) * (other + x));
    k % 2 == 1 ? value *= difference : value /= difference;
  }
  return value;
}

/// Where value |x r(-x^2)| = 1 on one side (-1, +1) of the root i, which it falls from to the next zero: the
/// logarithm of x over the root, found to round-off however small.
double crossing(const FlatFunction& function, double value, std::size_t i, int side) {
  const std::vector<double>& roots = function.roots;
  constexpr double far = 200;
  const bool last = side < 0 ? i == 0 : i + 1 == roots.size();
  const double end = last ? far : std::abs(std::log(roots[i + side] / roots[i]));
  double low = -far, high = std::log(end);
  for (int k = 0; k < 64; ++k) {
    const double middle = (low + high) / 2;
    (value * beyond(function, i, side * std::exp(middle)) > 1 ? low : high) = middle;
  }
  return side * std::exp((low + high) / 2);
}

/// Where K(s) / K_inf = prod (1 + s / zero_j) / prod (1 + s / pole_j) has a zero and a pole, around a root.
struct Pair {
  double root, to_zero, to_pole;  ///< [1/s], logarithms of zero and pole over the root

  double zero() const { return root * std::exp(to_zero); }
  double pole() const { return root * std::exp(to_pole); }
};

/// Partial fractions: g_j = -prod_l (1 - pole_j / zero_l) / prod_{l != j} (1 - pole_j / pole_l).
double strength(const std::vector<Pair>& pairs, std::size_t j) {
  const double pole = pairs[j].pole();
  double strength = std::expm1(pairs[j].to_pole - pairs[j].to_zero);
  for (std::size_t l = 0; l < pairs.size(); ++l) {
    if (l != j) strength *= (1 - pole / pairs[l].zero()) / (1 - pole / pairs[l].pole());
  }
  return strength;
}

}  // namespace

// With K = N / D, N and D of degree n, tan delta is the quotient of the odd and the even part of N(s) D(-s)
// at s = i omega: omega r(omega^2), and every r of degrees n - 1 and n with n poles is one. So the best is
// the value times Zolotarev's function f, whatever the value, and N(s) D(-s) vanishes where 1 + value s
// r(-s^2) does: n zeros of N left and n of D right of 0, real, one of each around every pole of r.
FlatLoss flat_loss(double value, FrequencyBand band, int branches) {
  check(value, band);
  if (branches < 1 || branches > most_flat_branches) {
    throw InvalidInput(
        fmt::format("branches = {} is not allowed: it must be 1 to {}", branches, most_flat_branches));
  }
  const FlatFunction function = flat_function(band, branches);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < function.roots.size(); i += 2) {
    pairs.push_back({function.roots[i], crossing(function, value, i, -1), crossing(function, value, i, 1)});
  }
  FlatLoss loss{{}, function.ripple, 1};
  for (std::size_t j = 0; j < pairs.size(); ++j) {
    loss.series.push_back({strength(pairs, j), 1 / pairs[j].pole()});
  }
  loss.rise = storage_modulus(loss.series, function.extremes.back()) /
              storage_modulus(loss.series, function.extremes.front());
  return loss;
}

FlatLoss flat_loss(double value, FrequencyBand band) {
  check(value, band);
  int branches = 1;
  while (branches < most_flat_branches && flat_function(band, branches).ripple > good_ripple) ++branches;
  return flat_loss(value, band, branches);
}

double relaxed_part(const PronySeries& series, double frequency) {
  check(series);
  if (!(frequency >= 0) || !std::isfinite(frequency)) {
    throw InvalidInput(
        fmt::format("frequency = {} Hz is not allowed: it must be finite and 0 or greater", frequency));
  }
  return 1 / storage_modulus(series, 2 * std::numbers::pi * frequency);
}

}  // namespace fiberchain::dem
