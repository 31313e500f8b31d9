#include "reference/time_scheme.hpp"

#include <cmath>
#include <limits>

#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

void require_not_negative(const char* argument, double value) {
  require_between(argument, value, 0, std::numeric_limits<double>::max());
}

}  // namespace

void validate(const TimeScheme& scheme) {
  require_between("theta", scheme.theta, 0, 0.5);
  require_between("beta", scheme.beta, 0, 1);
}

std::complex<double> step_root(const TimeScheme& scheme, double angle, double damping) {
  validate(scheme);
  require_positive("angle", angle);
  require_not_negative("damping", damping);
  // a (z - 1)^2 + d (z - 1) + angle^2 = 0
  const double a = 1 + 2 * scheme.theta * damping * angle + scheme.beta * angle * angle;
  const double d = (2 * damping + angle) * angle;
  const double square = (2 * damping + angle) * (2 * damping + angle) - 4 * a;
  if (square < 0) return {1 - d / (2 * a), angle * std::sqrt(-square) / (2 * a)};
  const double root = angle * std::sqrt(square);
  const double far = 1 - (d + root) / (2 * a), near = 1 - 2 * angle * angle / (d + root);
  return std::abs(far) > std::abs(near) ? far : near;
}

double stable_angle(const TimeScheme& scheme, double damping) {
  validate(scheme);
  require_not_negative("damping", damping);
  const double linear = (1 - 2 * scheme.theta) * damping, square = 0.25 - scheme.beta;
  if (square == 0 && linear == 0) return std::numeric_limits<double>::infinity();
  const double under = linear * linear + 4 * square;
  if (under < 0) return std::numeric_limits<double>::infinity();
  return 2 / (linear + std::sqrt(under));
}

ModeError error_law(const TimeScheme& scheme, double angle, double damping) {
  validate(scheme);
  require_positive("angle", angle);
  require_not_negative("damping", damping);
  const double lag = (0.5 - scheme.theta) * damping * angle, square = angle * angle;
  return {lag - (scheme.beta - 1.0 / 12) * square / 2, lag - (scheme.beta / 2 + 1.0 / 24) * square};
}

}  // namespace fiberchain::reference
