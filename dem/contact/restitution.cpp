#include "dem/contact/restitution.hpp"

#include <fmt/format.h>
#include <cmath>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

/// acos(z) / sqrt(1 - z^2), continued beyond z = 1.
double acos_over_sine(double z) {
  const double rest = 1 - z * z;
  if (std::abs(rest) < 1e-8) return 1 + rest / 6;
  return rest > 0 ? std::acos(z) / std::sqrt(rest) : std::acosh(z) / std::sqrt(-rest);
}

}  // namespace

double restitution_of(double damping_ratio) {
  if (!(damping_ratio >= 0)) {
    throw InvalidInput(
        fmt::format("damping ratio = {} is not allowed: it must be 0 or greater", damping_ratio));
  }
  return std::exp(-2 * damping_ratio * acos_over_sine(damping_ratio));
}

double damping_ratio_for(double restitution) {
  if (!(restitution > 0 && restitution <= 1)) {
    throw InvalidInput(
        fmt::format("restitution = {} is not allowed: it must be greater than 0 and at most 1", restitution));
  }
  if (restitution == 1) return 0;
  double low = 0, high = 1;
  while (restitution_of(high) > restitution) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-16 * high; ++i) {
    const double middle = (low + high) / 2;
    (restitution_of(middle) > restitution ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace fiberchain::dem
