#include "dem/model/prony_series.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {

std::complex<double> complex_modulus(const PronySeries& series, std::complex<double> s) {
  std::complex<double> sum = 1;
  for (const auto& [g, tau] : series) sum += g * s * tau / (1.0 + s * tau);
  return sum;
}

double storage_modulus(const PronySeries& series, double omega) {
  return complex_modulus(series, {0, omega}).real();
}

double loss_factor(const PronySeries& series, double omega) {
  const std::complex<double> K = complex_modulus(series, {0, omega});
  return K.imag() / K.real();
}

double unrelaxed_modulus(const PronySeries& series) {
  double sum = 1;
  for (const MaxwellBranch& branch : series) sum += branch.strength;
  return sum;
}

void check(const PronySeries& series) {
  for (const auto& [g, tau] : series) {
    if (!(g >= 0 && std::isfinite(g)))
      throw InvalidInput(fmt::format("strength = {} is not allowed: it must be finite and 0 or more", g));
    if (!(tau > 0 && std::isfinite(tau)))
      throw InvalidInput(fmt::format("time = {} is not allowed: it must be finite and greater than 0", tau));
  }
}

}  // namespace fiberchain::dem
