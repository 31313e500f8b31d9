// Reissner's beam: published values, 60-digit values, its limits (Elastica, Timoshenko), its robustness.
#include "reference/reissner.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reference/elastica.hpp"
#include "reference/small_deflection.hpp"

BOOST_AUTO_TEST_SUITE(reissner_test)

namespace ref = fiberchain::reference;
using ref::TipState;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Digits {
  double load, axial, shear, y, x, angle;
};

// 60-digit arithmetic (mpmath) on the first integral
// theta'^2 = 2 load (q - s)(1 + beta (q + s)/2), s = sin(theta) = q (1 - v^2), beta = load (1/axial -
// 1/shear); quadrature in v, q by a bracketed search.
constexpr Digits high_precision[] = {
    {0.37, infinity, 3.1, 0.23676123032820774, 0.022698363089901592, 0.17956391767324427},
    {1, infinity, 50, 0.31781387394153165, 0.061315658373047511, 0.45840953665973264},
    {4.3, 210, 75, 0.71744979519456426, 0.35536811652960354, 1.1400358675385845},
    {6, 1e9, 1.7, 3.5607542655194368, 0.78274950499880159, 0.28055286170322331},
    {3, 40, infinity, 0.648192222090575773, 0.236287451900954371, 1.0120563297408086},
    {1000, 2000, 500, 2.00986232000259288, 0.974180111025283887, 0.72972765622663565},
    {50, 900, 12, 4.1752789358349624, 0.93025141675381451, 0.24570768849674328}};

double relative(double value, double exact) { return std::abs(value / exact - 1); }

double largest_difference(const TipState& a, const TipState& b) {
  return std::max({std::abs(a.y - b.y), std::abs(a.x - b.x), std::abs(a.angle - b.angle)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(published_values) {
  // EI = 10, P = 10, L = 1, no stretch
  constexpr Digits published[] = {{0, 0, 500, 0.317813874, 0.061315658, 0},
                                  {0, 0, 50, 0.465413303, 0.103284917, 0},
                                  {0, 0, 5, 2.104087473, 0.376121399, 0}};
  for (const Digits& row : published) {
    const TipState tip = ref::reissner_cantilever(10, infinity, row.shear, 10, 1);
    BOOST_TEST(std::abs(tip.y - row.y) < 0.51e-9, "y at GA = " << row.shear);
    BOOST_TEST(std::abs(tip.x - row.x) < 0.51e-9, "x at GA = " << row.shear);
  }
}

BOOST_AUTO_TEST_CASE(equals_sixty_digit_values) {
  for (const Digits& exact : high_precision) {
    const TipState tip = ref::reissner_tip(exact.load, exact.axial, exact.shear);
    BOOST_TEST(relative(tip.y, exact.y) < 1e-12, "y at load " << exact.load);
    BOOST_TEST(relative(tip.x, exact.x) < 1e-12, "x at load " << exact.load);
    BOOST_TEST(relative(tip.angle, exact.angle) < 1e-12, "angle at load " << exact.load);
  }
}

BOOST_AUTO_TEST_CASE(rigid_in_stretch_and_shear_is_the_elastica) {
  for (int i = 0; i <= 90; ++i) {
    const double load = std::pow(10.0, -6 + i / 10.0);
    const TipState reissner = ref::reissner_tip(load, infinity, infinity);
    const TipState elastica = ref::elastica_closed_form(load);
    BOOST_TEST(largest_difference(reissner, elastica) < 1e-11, "load " << load);
    BOOST_TEST(relative(reissner.x, elastica.x) < 1e-10, "load " << load);
  }
}

BOOST_AUTO_TEST_CASE(equal_compliances_bend_like_the_elastica) {
  // axial = shear: the couple of stretch and shear cancels, so the angles are the Elastica's, and each
  // section is displaced by P/EA along the load over its length: y grows by load / axial, x not at all.
  const double load = 2.9;
  const TipState tip = ref::reissner_tip(load, 17, 17);
  const TipState elastica = ref::elastica_closed_form(load);
  BOOST_TEST(std::abs(tip.angle - elastica.angle) < 1e-12);
  BOOST_TEST(std::abs(tip.y - (elastica.y + load / 17)) < 1e-12);
  BOOST_TEST(std::abs(tip.x - elastica.x) < 1e-12);
}

BOOST_AUTO_TEST_CASE(tangent_at_zero_load) {
  // y = load (1/3 + 1/shear), angle = load/2, x = load^2 (1/15 + (1/shear - 1/axial)/3)
  const double load = 1e-6;
  for (const double shear : {0.7, 19.0, 3000.0}) {
    for (const double axial : {5.0, 270.0, infinity}) {
      const TipState tip = ref::reissner_tip(load, axial, shear);
      BOOST_TEST(relative(tip.y, ref::timoshenko_tip_y(load, shear)) < 1e-10);
      BOOST_TEST(relative(tip.angle, load / 2) < 1e-10);
      BOOST_TEST(relative(tip.x, load * load * (1.0 / 15 + (1 / shear - 1 / axial) / 3)) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(si_form_scales) {
  // EI = 3.1e-5 N m^2, L = 0.071 m: only the dimensionless groups count
  const double unit = 0.071 * 0.071 / 3.1e-5;
  const TipState a = ref::reissner_cantilever(3.1e-5, 40 / unit, 9 / unit, 2.2 / unit, 0.071);
  BOOST_TEST(largest_difference(a, ref::reissner_tip(2.2, 40, 9)) < 1e-13);
}

BOOST_AUTO_TEST_CASE(stiffer_beams_move_less_and_the_limits_meet) {
  // across every switch of the method: load, softness from hard to very soft, beta through -1
  for (const double load : {1e-4, 0.03, 1.0, 10.0, 137.0, 1000.0}) {
    for (const double axial : {infinity, 3000.0, 20.0}) {
      double previous = ref::reissner_tip(load, axial, infinity).y;
      for (double shear = 1e7; shear > 1e-3; shear /= 1.7) {
        const double y = ref::reissner_tip(load, axial, shear).y;
        BOOST_TEST(y >= previous * (1 - 1e-12), "load " << load << " shear " << shear);
        BOOST_TEST(y <= load / shear * 1.0001 + ref::reissner_tip(load, axial, infinity).y + 1e-9);
        previous = y;
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(both_forms_of_the_problem_meet_where_they_switch) {
  // rate = 1 separates them (reissner.cpp); here load = 1 and axial = shear = infinity
  const TipState below = ref::reissner_tip(1 - 1e-9, infinity, infinity);
  const TipState above = ref::reissner_tip(1 + 1e-9, infinity, infinity);
  BOOST_TEST(largest_difference(below, above) < 2e-9);
  BOOST_TEST(above.y > below.y);
  const double degenerate = 10;  // beta = -1: the rest angle only just reaches the vertical
  const TipState soft = ref::reissner_tip(degenerate, infinity, degenerate * (1 - 1e-9));
  const TipState hard = ref::reissner_tip(degenerate, infinity, degenerate * (1 + 1e-9));
  BOOST_TEST(largest_difference(soft, hard) < 2e-8);
}

BOOST_AUTO_TEST_CASE(shape_ends_at_the_tip) {
  for (const double load : {0.0, 0.2, 5.0, 300.0}) {
    const ref::BeamShape shape = ref::reissner_shape(load, 400, 25, 31);
    const TipState tip = ref::reissner_tip(load, 400, 25);
    BOOST_TEST(shape.x.size() == 31U);
    BOOST_TEST(std::abs(shape.y.back() - tip.y) < 1e-10);
    BOOST_TEST(std::abs(1 - shape.x.back() - tip.x) < 1e-10);
    BOOST_TEST(std::abs(shape.theta.back() - tip.angle) < 1e-10);
    BOOST_TEST(std::abs(shape.y[0]) + std::abs(shape.theta[0]) == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
