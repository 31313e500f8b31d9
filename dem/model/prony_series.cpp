#include "dem/model/prony_series.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {

std::complex<double> complex_modulus(const PronySeries& series, std::complex<double> s) {
  std::complex<double> modulus = 1;
  for (const MaxwellBranch& branch : series) {
    const std::complex<double> x = s * branch.time;
    modulus += branch.strength * (std::norm(x) > 1 ? 1.0 / (1.0 + 1.0 / x) : x / (1.0 + x));
  }
  return modulus;
}

namespace {

/// K' and K'' over K_inf in real numbers, of which complex ones are several times dearer.
struct Forced {
  double storage = 1, loss = 0;
};

Forced forced(const PronySeries& series, double omega) {
  Forced modulus;
  for (const MaxwellBranch& branch : series) {
    const double x = omega * branch.time;
    const double part = branch.strength / (x + 1 / x);  // x / (1 + x^2) without overflow; 0 at x = 0
    modulus.storage += x * part;
    modulus.loss += part;
  }
  return modulus;
}

}  // namespace

double storage_modulus(const PronySeries& series, double omega) { return forced(series, omega).storage; }

double loss_factor(const PronySeries& series, double omega) {
  const Forced modulus = forced(series, omega);
  return modulus.loss / modulus.storage;
}

double unrelaxed_modulus(const PronySeries& series) {
  double modulus = 1;
  for (const MaxwellBranch& branch : series) modulus += branch.strength;
  return modulus;
}

void check(const PronySeries& series) {
  for (const MaxwellBranch& branch : series) {
    if (!(branch.strength >= 0) || !std::isfinite(branch.strength)) {
      throw InvalidInput(
          fmt::format("strength = {} of a Maxwell branch is not allowed: it must be finite and 0 or greater",
                      branch.strength));
    }
    if (!(branch.time > 0) || !std::isfinite(branch.time)) {
      throw InvalidInput(
          fmt::format("time = {} s of a Maxwell branch is not allowed: it must be finite and greater than 0",
                      branch.time));
    }
  }
}

}  // namespace fiberchain::dem
