// A bend of a fiber that passes 45 degrees in simple shear, against the chain's own linearization in
// extension at half the rate.
#include <boost/test/unit_test.hpp>

#include "compare/flow/shear_passage.hpp"
#include "compare/study/errors.hpp"
#include "reference/compressed_chain.hpp"

BOOST_AUTO_TEST_SUITE(flow_shear_passage_test)

namespace compare = fiberchain::compare;
namespace reference = fiberchain::reference;

BOOST_AUTO_TEST_CASE(growth_at_45_degrees_is_that_of_half_the_rate) {
  for (const double number : {150.0, 400.0}) {
    const double expected = 0.5 * reference::chain_growth_mode({13, 0.17}, number / 2, 1).growth;
    const double measured =
        compare::growth_at_passage({.spheres = 13, .number = number, .poisson_ratio = 0.17});
    BOOST_TEST(measured == expected, boost::test_tools::tolerance(2e-3));
  }
}

BOOST_AUTO_TEST_CASE(threshold_in_shear_is_twice_that_in_extension) {
  const double expected = 2 * reference::chain_buckling_threshold({20, 0.3}, 1);
  BOOST_TEST(compare::passage_threshold(20, 0.9 * expected, 1.1 * expected, 0.02) == expected,
             boost::test_tools::tolerance(2e-4));
}

BOOST_AUTO_TEST_CASE(no_threshold_between_is_an_error) {
  BOOST_CHECK_THROW(compare::passage_threshold(10, 300, 400, 1), compare::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
