// The Elastica's free end by shooting and in closed form: against each other, against 60-digit values,
// against the table in circulation that is right and the one that is wrong.
#include "reference/elastica.hpp"

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(elastica_test)

namespace ref = fiberchain::reference;
using ref::TipState;

namespace {

struct Digits {
  double load, y, x, angle;
};

// 60-digit arithmetic (mpmath): with sin(theta) = q (1 - v^2) the length is
// int_0^1 2 sqrt(q) / (cos(theta) sqrt(2 load)) dv = 1, solved for ln(1 - q) by bisection and secant, the
// integrals by tanh-sinh quadrature on panels graded toward v = 0.
constexpr Digits high_precision[] = {
    {1e-6, 3.3333333333329524e-7, 6.6666666666653968e-14, 4.9999999999995417e-7},
    {0.05, 0.016661907303532245, 0.00016658735071652071, 0.024994273622545544},
    {0.7, 0.22148082956100598, 0.029943464417688935, 0.33561867374368589},
    {2.5, 0.55565946266080218, 0.209958457370735, 0.89499675099110822},
    {10, 0.81060902488029645, 0.55499559775375127, 1.4302855388038575},
    {100, 0.94142135086201098, 0.85857864456288208, 1.5706458846600332},
    {1000, 0.98147580634662821, 0.95527864045000421, 1.5707963267948354}};

double relative(double value, double exact) { return std::abs(value / exact - 1); }

}  // namespace

BOOST_AUTO_TEST_CASE(shooting_and_closed_form_agree_from_1e_6_to_1e_3) {
  double worst = 0;
  double worst_relative = 0;
  for (int i = 0; i <= 9 * 37; ++i) {
    const double load = std::pow(10.0, -6 + i / 37.0);
    const TipState a = ref::elastica_shooting(load);
    const TipState b = ref::elastica_closed_form(load);
    worst = std::max({worst, std::abs(a.y - b.y), std::abs(a.x - b.x), std::abs(a.angle - b.angle)});
    worst_relative =
        std::max({worst_relative, relative(a.y, b.y), relative(a.x, b.x), relative(a.angle, b.angle)});
  }
  BOOST_TEST_MESSAGE("largest difference " << worst << ", relative " << worst_relative);
  BOOST_TEST(worst < 1e-11);
  BOOST_TEST(worst > 0);  // two solutions, not one called twice
  BOOST_TEST(worst_relative < 1e-10);
}

BOOST_AUTO_TEST_CASE(both_equal_sixty_digit_values) {
  for (const Digits& exact : high_precision) {
    for (const TipState& tip : {ref::elastica_shooting(exact.load), ref::elastica_closed_form(exact.load)}) {
      BOOST_TEST(relative(tip.y, exact.y) < 2e-13, "y at load " << exact.load);
      BOOST_TEST(relative(tip.x, exact.x) < 5e-12, "x at load " << exact.load);
      BOOST_TEST(relative(tip.angle, exact.angle) < 2e-13, "angle at load " << exact.load);
    }
  }
}

BOOST_AUTO_TEST_CASE(distance_from_vertical_keeps_its_logarithm) {
  // pi/2 - angle -> 8 tan(pi/8) exp(-sqrt(load)) for large loads (pendulum near its separatrix)
  const double load = 196;
  const double expected = 8 * std::tan(std::numbers::pi / 8) * std::exp(-14.0);
  BOOST_TEST(std::numbers::pi / 2 - ref::elastica_closed_form(load).angle == expected,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::numbers::pi / 2 - ref::elastica_shooting(load).angle == expected,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(table_to_five_figures_and_the_one_that_is_wrong) {
  constexpr Digits table[] = {{1, 0.30172, 0.05643, 0},
                              {2, 0.49346, 0.16064, 0},
                              {5, 0.71379, 0.38763, 0},
                              {10, 0.81061, 0.55500, 0}};
  for (const Digits& row : table) {
    const TipState tip = ref::elastica_closed_form(row.load);
    BOOST_TEST(std::abs(tip.y - row.y) < 0.51e-5, "w/L at load " << row.load);
    BOOST_TEST(std::abs(tip.x - row.x) < 0.51e-5, "u/L at load " << row.load);
  }
  // circulating: u/L 0.0566 and w/L 0.3015 at load 1, 0.5584 and 0.6854 at load 10
  const TipState at_1 = ref::elastica_closed_form(1);
  const TipState at_10 = ref::elastica_closed_form(10);
  BOOST_TEST(std::abs(at_1.x - 0.0566) > 1e-4);
  BOOST_TEST(std::abs(at_1.y - 0.3015) > 1e-4);
  BOOST_TEST(std::abs(at_10.x - 0.5584) > 3e-3);
  BOOST_TEST(std::abs(at_10.y - 0.6854) > 0.1);
}

BOOST_AUTO_TEST_CASE(vanishing_load_follows_the_series) {
  // y = load/3 (1 - 4 load^2/35), x = load^2/15 (1 - 4 load^2/21), angle = load/2 (1 - 11 load^2/120)
  for (const double load : {1e-300, 1e-12, 3e-5, 1e-3}) {
    for (const TipState& tip : {ref::elastica_shooting(load), ref::elastica_closed_form(load)}) {
      const double square = load * load;
      BOOST_TEST(relative(tip.y, load / 3 * (1 - 4 * square / 35)) < 1e-11);
      BOOST_TEST(relative(tip.angle, load / 2 * (1 - 11 * square / 120)) < 1e-11);
      if (load > 1e-100) BOOST_TEST(relative(tip.x, square / 15 * (1 - 4 * square / 21)) < 1e-10);
    }
  }
  for (const TipState& tip : {ref::elastica_shooting(0), ref::elastica_closed_form(0)}) {
    BOOST_TEST(tip.y == 0);
    BOOST_TEST(tip.x == 0);
    BOOST_TEST(tip.angle == 0);
  }
}

BOOST_AUTO_TEST_CASE(shape_starts_at_the_clamp_and_ends_at_the_tip) {
  for (const double load : {0.0, 0.013, 1.7, 43.0}) {
    const ref::BeamShape shape = ref::elastica_shape(load, 38);
    const TipState tip = ref::elastica_closed_form(load);
    BOOST_TEST(shape.s.size() == 38U);
    BOOST_TEST(std::abs(shape.x[0]) + std::abs(shape.y[0]) + std::abs(shape.theta[0]) == 0);
    BOOST_TEST(std::abs(shape.y.back() - tip.y) < 1e-12);
    BOOST_TEST(std::abs(1 - shape.x.back() - tip.x) < 1e-12);
    BOOST_TEST(std::abs(shape.theta.back() - tip.angle) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(shape_satisfies_its_equations) {
  // curvature by moment balance theta' = load (x_tip - x), and unit speed, by central differences
  const double load = 3.3;
  const std::size_t n = 2001;
  const ref::BeamShape shape = ref::elastica_shape(load, n);
  const double h = 2.0 / static_cast<double>(n - 1);
  double worst_moment = 0;
  double worst_direction = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double curvature = (shape.theta[i + 1] - shape.theta[i - 1]) / h;
    const double slope = (shape.y[i + 1] - shape.y[i - 1]) / h;
    worst_moment = std::max(worst_moment, std::abs(curvature - load * (shape.x.back() - shape.x[i])));
    worst_direction = std::max(worst_direction, std::abs(slope - std::sin(shape.theta[i])));
  }
  BOOST_TEST(worst_moment < 1e-5);
  BOOST_TEST(worst_moment > 1e-9);
  BOOST_TEST(worst_direction < 1e-5);
}

BOOST_AUTO_TEST_CASE(a_call_takes_a_fraction_of_a_millisecond) {
  const auto start = std::chrono::steady_clock::now();
  double sum = 0;
  for (int i = 1; i <= 50; ++i) sum += ref::elastica_shooting(0.2 * i).y;
  const double each = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 50;
  BOOST_TEST_MESSAGE("shooting: " << each * 1e6 << " us a call (sum " << sum << ")");
  BOOST_TEST(each < 0.05);  // wide: other work may share the machine
}

BOOST_AUTO_TEST_SUITE_END()
