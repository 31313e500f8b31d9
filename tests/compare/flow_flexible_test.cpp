// Flexible chains in flows: buckling from both sides of the threshold, regimes in shear.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/flow/buckling.hpp"
#include "compare/flow/regimes.hpp"
#include "compare/study/errors.hpp"
#include "reference/compressed_chain.hpp"

BOOST_AUTO_TEST_SUITE(flow_flexible_test)

namespace compare = fiberchain::compare;
namespace reference = fiberchain::reference;

BOOST_AUTO_TEST_CASE(a_bend_decays_below_the_threshold_and_grows_above_as_the_linearization_says) {
  for (const int N : {7, 13}) {
    const double threshold = reference::chain_buckling_threshold({N, 0.17}, 1);
    for (const double ratio : {0.8, 0.99, 1.01, 1.6}) {
      const compare::BucklingCase asked{.spheres = N, .number = ratio * threshold, .poisson_ratio = 0.17};
      const compare::BucklingRun run = compare::run_buckling(asked);
      const double expected = reference::chain_growth_mode({N, 0.17}, asked.number, 1).growth;
      BOOST_TEST((run.growth > 0) == (ratio > 1));
      BOOST_TEST((run.amplitude.back() > run.amplitude[20]) == (ratio > 1));
      BOOST_TEST(std::abs(run.growth - expected) < 1e-4, run.growth << " against " << expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_threshold_is_found_between_a_run_that_decays_and_one_that_grows) {
  const auto found = compare::buckling_threshold_of(10, 120, 140, 0.2);
  BOOST_TEST(std::abs(found.middle() - 128.09) < 0.2);
  BOOST_TEST(found.below < found.above);
  BOOST_CHECK_THROW(compare::buckling_threshold_of(10, 130, 140, 0.2), compare::InputError);
  BOOST_CHECK_THROW(compare::buckling_threshold_of(10, 100, 120, 0.2), compare::InputError);
}

BOOST_AUTO_TEST_CASE(every_regime_is_told_from_the_others) {
  using enum compare::Regime;
  const auto points = compare::regime_points({{.spheres = 21, .elasto_viscous = 300},
                                              {.spheres = 21, .elasto_viscous = 1000},
                                              {.spheres = 21, .elasto_viscous = 2000},
                                              {.spheres = 21, .elasto_viscous = 20000},
                                              {.spheres = 41, .elasto_viscous = 1e6}},
                                             {});
  const compare::Regime expected[] = {rigid, springy, c_shaped, snake_turn, coil};
  for (std::size_t i = 0; i < points.size(); ++i) {
    BOOST_TEST((points[i].regime == expected[i]), "case " << i << ": " << name(points[i].regime));
    BOOST_TEST(points[i].status == "finished");
    BOOST_TEST(!points[i].turning.empty());
  }
  BOOST_TEST(std::abs(points[0].gradient_extent - 1) < 0.01);  // stands across the flow
  BOOST_TEST(points[3].gradient_extent < 0.5);                 // never does
  BOOST_TEST(points[0].inflections <= 1);
  BOOST_TEST(points[2].axis_half_turns == 1);
  BOOST_TEST(points[3].axis_half_turns == 0);
}

BOOST_AUTO_TEST_SUITE_END()
