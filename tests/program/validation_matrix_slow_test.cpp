#include "tests/program/validation_matrix.hpp"

BOOST_AUTO_TEST_SUITE(validation_matrix_slow_test)

BOOST_AUTO_TEST_CASE(the_validation_matrix_holds) { fiberchain::test::matrix_holds({}); }

BOOST_AUTO_TEST_SUITE_END()
