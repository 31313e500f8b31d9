// A smooth fiber on a drum slides as a rod that is thick and bends; spheres on spheres do not.
#include "compare/capstan/capstan.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(capstan_study_test)

using namespace fiberchain::compare;

/// At no round numbers, also as a helix and of bonds longer than thick.
BOOST_AUTO_TEST_CASE(smooth_fibers_have_the_tension_of_the_rod) {
  for (const CapstanCase& asked :
       {CapstanCase{.friction = 0.23, .turning = 2.3, .drum = 23.7, .bending = 0.17},
        CapstanCase{.friction = 0.17, .turning = 4.4, .drum = 17.3, .bending = 0.09, .spacing = 1.7}}) {
    const CapstanPoint point = capstan_point(asked);
    BOOST_TEST_MESSAGE("ratio " << point.ratio << ", rod " << point.expected << ", thread " << point.euler
                                << ", ripple " << point.spread << ", " << point.run_time << " s");
    BOOST_TEST(point.status == "converged");
    BOOST_TEST(std::abs(point.ratio / point.expected - 1) < 6e-3);
    BOOST_TEST(point.spread < 2e-3);
    BOOST_TEST(point.ratio < 0.97 * point.euler);
  }
}

BOOST_AUTO_TEST_CASE(cases_are_those_that_surfaces_can_have) {
  const auto cases = capstan_cases({.spacing = {1, 2}});
  BOOST_TEST(cases.size() == 2u * (4 * 2 + 4 + 2 * 2 + 2));
  BOOST_CHECK_THROW(capstan_cases({.surface = {DrumSurface::wall}, .spacing = {2}}), InputError);
  BOOST_CHECK_THROW(wound_fiber({.surface = DrumSurface::ring, .turning = 4}), InputError);
  const auto none = capstan_points({{}}, {.stopped = [] { return true; }});
  BOOST_TEST(none.front().status == "not begun");
  BOOST_TEST(capstan_table(none).rows().size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
