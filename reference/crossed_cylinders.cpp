#include "reference/crossed_cylinders.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <numbers>

#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

/// Of an ellipse with half axes a and b = q a under p_0 sqrt(1 - x^2/a^2 - y^2/b^2): the gap's curvatures are
/// A = p_0/E* (b/(e^2 a^2)) (K - E), B = p_0/E* (b/(e^2 a^2)) (a^2/b^2 E - K).
struct Ellipse {
  double K, E, A, B;  ///< A, B over p_0/(E* a)
};

Ellipse ellipse_of(double q) {
  const double square = 1 - q * q, e = std::sqrt(square);
  const double K = gsl_sf_ellint_Kcomp(e, GSL_PREC_DOUBLE), E = gsl_sf_ellint_Ecomp(e, GSL_PREC_DOUBLE);
  return {K, E, q / square * (K - E), q / square * (E / (q * q) - K)};
}

}  // namespace

double elliptic_contact_stiffness(double modulus, double A, double B) {
  if (!(modulus > 0)) throw InvalidArgument("modulus", modulus, "above 0");
  if (!(A > 0)) throw InvalidArgument("A", A, "above 0");
  if (!(B >= A)) throw InvalidArgument("B", B, "at least A");
  double low = 1e-9, high = 1 - 1e-7;
  for (int i = 0; i < 200; ++i) {
    const double q = (low + high) / 2;
    const Ellipse at = ellipse_of(q);
    (at.A / at.B < A / B ? low : high) = q;
  }
  const double q = (low + high) / 2;
  const Ellipse at = ellipse_of(q);
  const double pressure = A / at.A;  // p_0/(E* a)
  // delta = p_0/E* b K, F = 2/3 pi p_0 a b
  return 2.0 / 3 * std::numbers::pi * modulus * pressure * q / std::pow(pressure * q * at.K, 1.5);
}

double crossed_cylinder_stiffness(double modulus, double radius_1, double radius_2, double angle) {
  if (!(radius_1 > 0)) throw InvalidArgument("radius_1", radius_1, "above 0");
  if (!(radius_2 > 0)) throw InvalidArgument("radius_2", radius_2, "above 0");
  if (!(angle > 0 && angle <= std::numbers::pi / 2))
    throw InvalidArgument("angle", angle, "above 0 and at most pi/2");
  const double c1 = 1 / radius_1, c2 = 1 / radius_2, sum = (c1 + c2) / 2,
               difference = 0.5 * std::sqrt(c1 * c1 + c2 * c2 + 2 * c1 * c2 * std::cos(2 * angle));
  return elliptic_contact_stiffness(modulus, (sum - difference) / 2, (sum + difference) / 2);
}

}  // namespace fiberchain::reference
