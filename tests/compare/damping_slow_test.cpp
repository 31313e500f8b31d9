// What damping_test.cpp holds, carried to longer chains.
#include <boost/test/unit_test.hpp>

#include "tests/compare/elastica_error.hpp"

BOOST_AUTO_TEST_SUITE(damping_slow_test)

using namespace fiberchain;

BOOST_AUTO_TEST_CASE(second_order_holds_from_20_to_40_bonds) {
  const double order = std::log2(test::elastica_error(20, 4.0) / test::elastica_error(40, 16.0));
  BOOST_TEST(order > 1.85);
  BOOST_TEST(order < 2.15);
}

BOOST_AUTO_TEST_CASE(marched_damping_of_60_bonds_is_that_of_the_linear_chain) {
  for (const double damping : {0.01, 1.0, 3.0}) {
    compare::DampingOptions options;
    options.elastica = false;
    const auto p =
        compare::damping_points(
            {{.aspect_ratio = 60, .poisson_ratio = 0.17, .load = 1e-5, .bond_damping = damping}}, options)
            .front();
    BOOST_TEST(std::abs(p.damping / p.damping_modes - 1) < 2e-4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
