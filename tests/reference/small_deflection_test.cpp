// Closed forms: Eq 12 of the paper, Timoshenko's tip, the circle of the end moment.
#include "reference/small_deflection.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/ring.hpp"

BOOST_AUTO_TEST_SUITE(small_deflection_test)

namespace ref = fiberchain::reference;

BOOST_AUTO_TEST_CASE(eq_12_in_si_units) {
  // R = 1.3 mm, E = 2.6 MPa, L = 37 mm, P = 0.7 mN: P L^3/(3 E I), I = pi R^4/4, by hand
  const double second_moment = std::numbers::pi * std::pow(1.3e-3, 4) / 4;
  const ref::SmallDeflection tip = ref::small_deflection(0.7e-3, 37e-3, 2.6e6, second_moment);
  BOOST_TEST(tip.deflection == 0.7e-3 * 37e-3 * 37e-3 * 37e-3 / (3 * 2.6e6 * second_moment),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(tip.deflection == 2.02649398460825e-3, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(tip.rotation == 1.5 * tip.deflection / 37e-3, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ref::small_deflection(-0.7e-3, 37e-3, 2.6e6, second_moment).deflection == -tip.deflection);
}

BOOST_AUTO_TEST_CASE(dimensionless_forms) {
  BOOST_TEST(ref::small_deflection_tip_y(0.21) == 0.07, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(ref::small_deflection_tip_angle(0.21) == 0.105, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(ref::timoshenko_tip_y(0.21, 3) == 0.14, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(ref::timoshenko_tip_y(0.21, std::numeric_limits<double>::infinity()) == 0.07,
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(end_moment_bends_the_beam_to_a_circle) {
  using std::numbers::pi;
  const ref::TipState ring = ref::end_moment_tip(2 * pi);
  BOOST_TEST(std::abs(ring.y) < 1e-15);
  BOOST_TEST(std::abs(ring.x - 1) < 1e-15);
  BOOST_TEST(ring.angle == 2 * pi);
  const ref::TipState half = ref::end_moment_tip(pi);
  BOOST_TEST(half.y == 2 / pi, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(half.x == 1.0, boost::test_tools::tolerance(1e-15));
  const ref::TipState quarter = ref::end_moment_tip(-pi / 2);
  BOOST_TEST(quarter.y == -2 / pi, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(quarter.x == 1 - 2 / pi, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(small_end_moments_keep_their_digits) {
  BOOST_TEST(ref::end_moment_tip(0).y == 0);
  BOOST_TEST(ref::end_moment_tip(3e-7).x == 1.5e-14, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(ref::end_moment_tip(3e-7).y == 1.5e-7, boost::test_tools::tolerance(1e-13));
  // both sides of the switch to the series
  const double below = ref::end_moment_tip(0.1 * (1 - 1e-12)).x;
  BOOST_TEST(ref::end_moment_tip(0.1).x == below, boost::test_tools::tolerance(1e-11));
}

BOOST_AUTO_TEST_SUITE_END()
