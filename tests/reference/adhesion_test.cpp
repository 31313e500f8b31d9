// Adhesion by the contact radius: known coefficients, limits, the curve's own points.
#include "reference/adhesion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(adhesion_test)

namespace ref = fiberchain::reference;

namespace {

constexpr ref::ElasticBody one{0.83e-3, 2.4e-6, 2.6e7, 0.31}, other{1.37e-3, 1.9e-5, 7.1e6, 0.22};
constexpr double w = 0.047;

}  // namespace

BOOST_AUTO_TEST_CASE(jkr_has_its_known_points) {
  const ref::HertzPair pair = ref::hertz_pair(one, other);
  const double pull = ref::jkr_pull_off(pair, w), R = pair.radius, E = pair.modulus;
  // at the touch 8/9 of the pull-off force, at the end of the branch 5/9
  const ref::JkrState touch = ref::jkr_state(pair, w, ref::jkr_radius_at_touch(pair, w)),
                      end = ref::jkr_state(pair, w, ref::jkr_radius_at_end(pair, w));
  BOOST_TEST(std::abs(touch.overlap) < 1e-12 * std::abs(end.overlap));
  BOOST_TEST(touch.force / pull == -8.0 / 9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(end.force / pull == -5.0 / 9, boost::test_tools::tolerance(1e-12));
  double least = 0;
  for (int k = 0; k <= 2000; ++k)
    least = std::min(least, ref::jkr_force(pair, w, end.overlap * (1 - k / 2000.0)));
  BOOST_TEST(-least / pull == 1, boost::test_tools::tolerance(1e-6));
  // Thornton & Ning, Powder Technol. 99 (1998) 154
  BOOST_TEST(ref::jkr_cycle_loss(pair, w) / std::cbrt(std::pow(w, 5) * std::pow(R, 4) / (E * E)) == 7.09,
             boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(little_adhesion_is_hertz_and_its_pull) {
  const ref::HertzPair pair = ref::hertz_pair(one, other);
  const double d = 3e-5, tiny = 1e-9;
  const double hertz = ref::hertz_stiffness(pair) * std::pow(d, 1.5), force = ref::jkr_force(pair, tiny, d);
  BOOST_TEST(force / hertz == 1, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(ref::dmt_pull_off(pair, w) == 2 * std::numbers::pi * w * pair.radius);
  BOOST_CHECK_THROW(ref::jkr_pull_off(pair, 0), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
