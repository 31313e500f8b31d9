#include "compare/material/modulus_rise.hpp"

#include <cmath>
#include <numbers>

namespace fiberchain::compare {
namespace {

/// ln|K(w)/K(0)|; the integrand is smooth at u = 0, which no point meets.
double log_modulus(const std::function<double(double)>& loss_factor, double w) {
  constexpr double h = 0.02, far = 40;
  const double here = std::atan(loss_factor(w));
  double sum = 0;
  for (double u = -far + h / 2; u < far; u += h)
    sum += (std::atan(loss_factor(w * std::exp(u))) - here * std::exp(u)) / -std::expm1(2 * u);
  return 2 / std::numbers::pi * h * sum;
}

}  // namespace

double causal_rise(const std::function<double(double)>& loss_factor, double low, double high) {
  const auto storage = [&](double w) {
    return std::exp(log_modulus(loss_factor, w)) * std::cos(std::atan(loss_factor(w)));
  };
  return storage(high) / storage(low);
}

}  // namespace fiberchain::compare
