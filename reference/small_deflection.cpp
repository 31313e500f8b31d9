#include "reference/small_deflection.hpp"

#include <limits>

#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

void require_finite(const char* argument, double value) {
  constexpr double largest = std::numeric_limits<double>::max();
  require_between(argument, value, -largest, largest);
}

}  // namespace

double small_deflection_tip_y(double load) {
  require_finite("load", load);
  return load / 3;
}

double small_deflection_tip_angle(double load) {
  require_finite("load", load);
  return load / 2;
}

double timoshenko_tip_y(double load, double shear) {
  require_finite("load", load);
  require_positive_or_infinite("shear", shear);
  return load * (1.0 / 3 + 1 / shear);
}

SmallDeflection small_deflection(double force, double length, double modulus, double second_moment) {
  require_finite("force", force);
  require_positive("length", length);
  require_positive("modulus", modulus);
  require_positive("second_moment", second_moment);
  const double load = force * length * length / (modulus * second_moment);
  return {length * load / 3, load / 2};
}

}  // namespace fiberchain::reference
