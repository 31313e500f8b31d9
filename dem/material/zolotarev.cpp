#include "dem/material/zolotarev.hpp"

#include <cmath>
#include <numbers>

namespace fiberchain::dem {
namespace {

double arithmetic_geometric_mean(double a, double b) {
  while (std::abs(a - b) > 1e-8 * a) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return (a + b) / 2;
}

/// -ln q = pi K' / K of Jacobi's nome for a modulus k.
double log_nome(double k) {
  const double complementary = std::sqrt((1 - k) * (1 + k));
  return std::numbers::pi * arithmetic_geometric_mean(1, complementary) / arithmetic_geometric_mean(1, k);
}

struct Station {
  double root, extreme;
};

/// sqrt(k) sc(u, k') and sqrt(k) / dn(u, k') at u = part K', k' the complementary modulus, by the theta
/// functions of u i (Abramowitz & Stegun 16.27, 16.36, 16.20): -i theta_1 / theta_4 and theta_2 / theta_3.
Station station(double part, double log_nome) {
  if (part > 0.5) {  // of K' - u both are inverse to those of u
    const Station mirrored = station(1 - part, log_nome);
    return {1 / mirrored.root, 1 / mirrored.extreme};
  }
  constexpr int terms = 16;  // log_nome is 0.25 where k is 1 but for round-off
  double one = 0, two = 0, three = 1, four = 1;
  for (int n = 0; n < terms; ++n) {
    const double sign = n % 2 == 0 ? 1 : -1, odd = n + 0.5, even = n + 1;
    const auto term = [&](double m, double side) { return std::exp(-log_nome * m * (m + side * part)); };
    one += sign * (term(odd, -1) - term(odd, 1));
    two += term(odd, -1) + term(odd, 1);
    three += term(even, -1) + term(even, 1);
    four -= sign * (term(even, -1) + term(even, 1));
  }
  return {one / four, two / three};
}

double value(const FlatFunction& function, double x) {
  double value = function.factor * x;
  for (std::size_t i = 0; i < function.roots.size(); ++i) {
    const double square = function.roots[i] * function.roots[i] + x * x;
    i % 2 == 1 ? value *= square : value /= square;
  }
  return value;
}

}  // namespace

FlatFunction flat_function(FrequencyBand band, int branches) {
  const double L = log_nome(band.low / band.high);
  const double middle = 2 * std::numbers::pi * std::sqrt(band.low) * std::sqrt(band.high);
  FlatFunction function{{}, {}, 1, 0};
  for (int i = 0; i <= 2 * branches; ++i) {
    const Station at = station(i / (2.0 * branches), L);
    function.extremes.push_back(at.extreme);
    if (i > 0 && i < 2 * branches) function.roots.push_back(at.root);
  }
  const double least = value(function, function.extremes[0]);
  const double largest = value(function, function.extremes[1]);
  function.factor = 2 / (largest + least) * middle;
  function.ripple = (largest - least) / (largest + least);
  for (double& root : function.roots) root *= middle;
  for (double& extreme : function.extremes) extreme *= middle;
  return function;
}

}  // namespace fiberchain::dem
