#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <numbers>

#include "reference/elastica.hpp"
#include "reference/elastica_bounds.hpp"
#include "reference/errors.hpp"
#include "reference/gsl_root.hpp"
#include "reference/gsl_status.hpp"

// With q = sin(theta_tip), complementary modulus k'^2 = (1 - q)/2 and c = cos(amplitude), the first
// integral theta'^2 = 2 load (q - sin(theta)) gives
//   sqrt(load)   = I_0,  y sqrt(load) = q I_0 - (1 + q) I_2,
//   I_n = int_0^C c^n dc / sqrt((1 - c^2)(k'^2 + k^2 c^2)),  C^2 = q / (1 + q),
//   I_0 = C R_F(k'^2, k'^2/(1+q), 1/2),  I_2 = C^3/3 k'^2 R_D(k'^2/(1+q), 1/2, k'^2),
// and the free end is at 1 - x = sqrt(2 q / load).

namespace fiberchain::reference {
namespace {

double carlson_rf(double x, double y, double z) {
  gsl_sf_result result;
  check_gsl(gsl_sf_ellint_RF_e(x, y, z, GSL_PREC_DOUBLE, &result), "Carlson's R_F");
  return result.val;
}

double carlson_rd(double x, double y, double z) {
  gsl_sf_result result;
  check_gsl(gsl_sf_ellint_RD_e(x, y, z, GSL_PREC_DOUBLE, &result), "Carlson's R_D");
  return result.val;
}

/// The Elastica whose free end is at w = ln tan(pi/4 - theta_tip/2), that is k'^2/k^2 = exp(2 w).
struct ByModulus {
  explicit ByModulus(double w)
      : q(-std::tanh(w)), k2_complement(1 / (1 + std::exp(-2 * w))), c(std::sqrt(q / (1 + q))) {}

  double root_load() const { return c * carlson_rf(k2_complement, k2_complement / (1 + q), 0.5); }

  /// y = q - (1 + q) I_2 / sqrt(load), with C^2 = q / (1 + q) put in
  double rise() const {
    const double rd = carlson_rd(k2_complement / (1 + q), 0.5, k2_complement);
    return q * (1 - c / root_load() * k2_complement * rd / 3);
  }

  double q;
  double k2_complement;
  double c;
};

/// 1 - sqrt(2 q / load) = 1 - sqrt(1 - q^2/3) / S with S from R_F = S / sqrt(mean of its arguments):
/// Carlson's expansion of S in the symmetric functions of the arguments' departures from their mean,
/// which are of order q, is exact to q^8. For small q, where the difference would cancel.
double small_shortening(double q) {
  const double mean = (3 - q * q) / (6 * (1 + q));
  const double a = q * q / (3 * (1 + q)) / mean;
  const double b = -(q * q + 3 * q) / (6 * (1 + q)) / mean;
  const double e2 = a * b - (a + b) * (a + b);
  const double e3 = -a * b * (a + b);
  const double s = -e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44 - 5 * e2 * e2 * e2 / 208 +
                   3 * e3 * e3 / 104 + e2 * e2 * e3 / 16;
  return -std::expm1(0.5 * std::log1p(-q * q / 3) - std::log1p(s));
}

}  // namespace

TipState elastica_closed_form(double load) {
  require_between("load", load, 0, max_elastica_load);
  if (load == 0) return {0, 0, 0};
  const double target = std::sqrt(load);
  const double bound = detail::elastica_tip_bound(load) * (1 + 1e-9);
  const auto residual = [&](double part) {
    return part == 0 ? -1 : ByModulus(part * bound).root_load() / target - 1;
  };
  const double w = bound * detail::find_root(residual, 0, 1, {}, "modulus of the Elastica");
  const ByModulus solution(w);
  const double x = solution.q < 0.01 ? small_shortening(solution.q) : 1 - std::sqrt(2 * solution.q) / target;
  return {solution.rise(), x, -2 * std::atan(std::tanh(w / 2))};
}

}  // namespace fiberchain::reference
