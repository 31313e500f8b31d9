// Linear stability of a compressed filament: the numbers known, the equation itself, limits, and time.
#include "reference/filament_buckling.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(filament_buckling_test)

namespace ref = fiberchain::reference;

namespace {

/// Largest departure from (sigma - q) y = -y''''/number - (1/2) ((1/4 - s^2) y')' over its largest term, by
/// differences of fourth order.
double residual(const ref::FilamentMode& mode, double number, double q) {
  const double h = 0.01;
  double worst = 0;
  double scale = 0;
  for (const double s : {-0.41, -0.2, 0.03, 0.17, 0.4}) {
    const auto f = ref::filament_deflection(mode.coefficients,
                                            {s - 3 * h, s - 2 * h, s - h, s, s + h, s + 2 * h, s + 3 * h});
    const double d1 = (f[1] - 8 * f[2] + 8 * f[4] - f[5]) / (12 * h);
    const double d2 = (-f[1] + 16 * f[2] - 30 * f[3] + 16 * f[4] - f[5]) / (12 * h * h);
    const double d4 =
        (-f[0] + 12 * f[1] - 39 * f[2] + 56 * f[3] - 39 * f[4] + 12 * f[5] - f[6]) / (6 * h * h * h * h);
    const double compression = ((0.25 - s * s) * d2 - 2 * s * d1) / 2;
    worst = std::max(worst, std::abs((mode.growth - q) * f[3] + d4 / number + compression));
    scale = std::max({scale, std::abs(d4 / number), std::abs(compression)});
  }
  return worst / scale;
}

double rms(const std::vector<double>& coefficients) {
  double sum = 0;
  for (const double a : coefficients) sum += a * a;
  return std::sqrt(sum);
}

}  // namespace

BOOST_AUTO_TEST_CASE(known_thresholds) {
  BOOST_TEST(std::abs(ref::buckling_threshold(1) - 123.504) < 0.0006);
  BOOST_TEST(std::abs(ref::buckling_threshold(2) - 510.14) < 0.006);
  BOOST_TEST(std::abs(ref::buckling_threshold(3) - 1167.7) < 0.06);
  BOOST_TEST(std::abs(2 * ref::buckling_threshold(1) - 247.007) < 0.0006);  // shear at 45 degrees
}

BOOST_AUTO_TEST_CASE(known_growth_rates) {
  BOOST_TEST(std::abs(ref::filament_mode(200, 1).growth - 1.55249) < 0.6e-5);
  BOOST_TEST(std::abs(ref::filament_mode(400, 1).growth - 2.81112) < 0.6e-5);
  BOOST_TEST(std::abs(ref::filament_mode(800, 1).growth - 3.46098) < 0.6e-5);
}

BOOST_AUTO_TEST_CASE(growth_changes_sign_at_the_threshold) {
  for (const double q : {0.0, 0.5, 1.0, 1.3}) {
    for (int mode = 1; mode <= ref::max_filament_mode; ++mode) {
      const double number = ref::buckling_threshold(mode, q);
      const double slope = ref::filament_mode(1.001 * number, mode, q).growth;
      BOOST_TEST(std::abs(ref::filament_mode(number, mode, q).growth) < 1e-6 * slope + 1e-9);
      BOOST_TEST(ref::filament_mode(0.999 * number, mode, q).growth < 0);
      BOOST_TEST(slope > 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(shapes_satisfy_the_equation) {
  for (const double q : {0.5, 1.0}) {
    for (const double number : {37.0, 123.504, 200.0, 950.0}) {
      for (const int mode : {1, 2, 3}) {
        const auto found = ref::filament_mode(number, mode, q);
        BOOST_TEST(residual(found, number, q) < 3e-4, "mode " << mode << " at " << number);
        BOOST_TEST(residual({found.growth * 1.02 + 0.02, found.coefficients}, number, q) > 1e-3);
        BOOST_TEST(rms(found.coefficients) == 1, boost::test_tools::tolerance(1e-12));
        BOOST_TEST((found.coefficients[0] == 0 && found.coefficients[1] == 0));
        const auto y = ref::filament_deflection(found.coefficients, {-0.5, -0.31, 0.31, 0.5});
        const double sign = mode % 2 == 1 ? 1 : -1;
        BOOST_TEST(y[0] == sign * y[3], boost::test_tools::tolerance(1e-12));
        BOOST_TEST(y[1] == sign * y[2], boost::test_tools::tolerance(1e-10));
        BOOST_TEST(y[3] > 0);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(ends_are_free) {
  const double h = 1e-3;
  const auto y = ref::filament_deflection(ref::filament_mode(300, 1).coefficients,
                                          {0.5 - 3 * h, 0.5 - 2 * h, 0.5 - h, 0.5, 0, -h, h});
  const double end = (2 * y[3] - 5 * y[2] + 4 * y[1] - y[0]) / (h * h);
  const double middle = (y[5] - 2 * y[4] + y[6]) / (h * h);
  BOOST_TEST(std::abs(end) < 1e-3 * std::abs(middle));
  BOOST_TEST(std::abs(middle) > 1);
}

BOOST_AUTO_TEST_CASE(stiff_filament_decays_as_a_free_beam) {
  // number -> 0: sigma = -beta^4/number, cos(beta) cosh(beta) = 1
  const std::array<double, 4> beta{4.730040744862704, 7.853204624095838, 10.995607838001671,
                                   14.137165491257464};
  for (int mode = 1; mode <= 4; ++mode) {
    const double number = 1e-4;
    const double exact = -std::pow(beta[static_cast<std::size_t>(mode - 1)], 4) / number;
    BOOST_TEST(ref::filament_mode(number, mode).growth == exact, boost::test_tools::tolerance(1e-5));
  }
}

BOOST_AUTO_TEST_CASE(long_filament_grows_nearly_as_the_fastest_wave) {
  // infinite filament under the tension -zeta e L^2/8: at most q + number/256
  const double number = 1e5;
  const auto growth = ref::growth_rates(number, 2);
  BOOST_TEST(growth[0] < 1 + number / 256);
  BOOST_TEST(growth[0] > 0.9 * number / 256);
}

BOOST_AUTO_TEST_CASE(constant_compression_gives_back_the_modes) {
  const double number = 260;
  for (const int mode : {1, 2}) {
    auto found = ref::filament_mode(number, mode);
    found.coefficients.resize(24);
    const auto history = ref::deflection_history(number, [](double) { return 1.0; }, found.coefficients,
                                                 {0, 0.3, 0.8}, {1e-11, 1e-14});
    const double growth = rms(history.coefficients[2]) / rms(history.coefficients[0]);
    BOOST_TEST(std::log(growth) / 0.8 == found.growth, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(history.statistics.steps > 10);
  }
}

BOOST_AUTO_TEST_CASE(turning_filament_in_closed_form) {
  // drive alone integrates to a power of sin^2(angle); one bending polynomial only decays beside it, by
  // 720/number
  const double angle = 2.7;
  const double number = 4100;
  const auto history = ref::deflection_history(number, ref::shear_compression(angle), {0.3, 0.2, 0.1},
                                               {1.1, 4.9}, {1e-11, 1e-15});
  std::size_t k = 0;
  for (const double t : {1.1, 4.9}) {
    const double cotangent = 1 / std::tan(angle) + t;
    const double turned = 1 / (1 + cotangent * cotangent) / (std::sin(angle) * std::sin(angle));
    const auto& a = history.coefficients[k++];
    BOOST_TEST(a[0] == 0.3 * std::sqrt(turned), boost::test_tools::tolerance(1e-8));
    BOOST_TEST(a[1] == 0.2 * turned, boost::test_tools::tolerance(1e-8));
    BOOST_TEST(a[2] == 0.1 * turned * turned * std::exp(-720 * t / number),
               boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(compressive_quadrant_lets_only_flexible_filaments_buckle) {
  // from 0.99 pi down to pi/2: amplitude of the bending against its start
  const double angle = 0.99 * std::numbers::pi;
  const double through = -1 / std::tan(angle);
  const auto amplification = [&](double number, std::size_t polynomials) {
    auto start = ref::filament_mode(247, 1).coefficients;
    start.resize(polynomials);
    const auto history =
        ref::deflection_history(number, ref::shear_compression(angle), start, {through}, {1e-9, 1e-14});
    return rms(history.coefficients[0]);
  };
  BOOST_TEST(amplification(100, 24) < 1e-2);
  BOOST_TEST(amplification(2000, 24) > 1e2);
  BOOST_TEST(amplification(900, 24) == amplification(900, 34), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(ref::shear_compression(2.0)(0) == -std::sin(4.0) / 2, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(ref::buckling_threshold(0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::buckling_threshold(13), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::buckling_threshold(1, -0.1), ref::InvalidArgument);
  for (const double bad : {0.0, -3.0, 2e5, not_a_number}) {
    BOOST_CHECK_THROW(ref::filament_mode(bad, 1), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::growth_rates(bad, 2), ref::InvalidArgument);
  }
  BOOST_CHECK_THROW(ref::growth_rates(200, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::filament_deflection({1}, {0.51}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::shear_compression(0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::shear_compression(not_a_number), ref::InvalidArgument);
  const auto steady = [](double) { return 1.0; };
  BOOST_CHECK_THROW(ref::deflection_history(200, steady, {1}, {1}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::deflection_history(-1, steady, {1, 1, 1}, {1}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::deflection_history(200, steady, {1, 1, 1}, {2, 1}), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
