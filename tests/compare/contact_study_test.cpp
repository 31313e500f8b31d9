// Impacts and adhesion through the engine: what the study reports, and that it tells a wrong law.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/contact/adhesion.hpp"
#include "compare/contact/experiments.hpp"
#include "compare/contact/study.hpp"
#include "compare/study/errors.hpp"
#include "reference/adhesion.hpp"
#include "reference/friction.hpp"

BOOST_AUTO_TEST_SUITE(contact_study_test)

using namespace fiberchain;
using namespace fiberchain::compare;

namespace {

ImpactOutcome fine(const ImpactCase& impact) {
  return marched_impact(impact, 0.25 * default_step(impact), 0.35);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_test_is_there_twice_and_its_error_is_seen) {
  for (int test = 1; test <= impact_tests; ++test) {
    const auto impacts = impact_cases(test, {25});
    BOOST_TEST(impacts.size() >= 2u);
    ImpactCase impact = impacts.front();
    const ImpactReference expected = impact_reference(impact);
    const ImpactOutcome found = fine(impact);
    BOOST_TEST(impact_error(impact, found, expected) < 1e-3, "test " << test);
    BOOST_TEST(impact_error(impact, found, expected) > 1e-9);
    impact.first.youngs_modulus *= 1.1, impact.restitution *= 0.95;
    BOOST_TEST(impact_error(impact, fine(impact), expected) > 1e-3, "test " << test << " sees no change");
  }
  BOOST_CHECK_THROW(impact_cases(9, {25}), InputError);
}

BOOST_AUTO_TEST_CASE(sliding_through_is_momentum_of_rigid_bodies) {
  const reference::ElasticBody one{0.83e-3, 2.4e-6, 2.6e8, 0.31}, two{1.37e-3, 1.9e-5, 7.1e7, 0.22};
  const reference::PlanarMotion a{{0.3, 1.9}, 41.0}, b{{-0.11, -0.2}, 87.0};
  const auto after = reference::sliding_impact(one, two, 0.07, 0.8, a, b);
  for (int k = 0; k < 2; ++k) {
    BOOST_TEST(one.mass * after[0].velocity[k] + two.mass * after[1].velocity[k] ==
                   one.mass * a.velocity[k] + two.mass * b.velocity[k],
               boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(after[1].velocity[0] - after[0].velocity[0] == 0.8 * 0.41, boost::test_tools::tolerance(1e-12));
  const auto wall =
      reference::sliding_impact(one, {INFINITY, INFINITY, 1e9, 0.3}, 0.07, 0.8, {{0.3, 1.9}, 0}, {});
  const auto closed = reference::friction_impact({1.9, 0}, 0.3, 0.07, 0.8);
  BOOST_TEST(wall[0].velocity[1] == closed.after.tangential, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.radius * wall[0].spin == closed.after.surface_spin, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(points_of_others_are_read) {
  BOOST_TEST(experiment_points("kharaz", "rebound_angle").x.size() == 11u);
  BOOST_TEST(experiment_points("fem", "recoil").x.size() == 17u);
  BOOST_CHECK_THROW(experiment_points("kharaz", "pages"), InputError);
}

BOOST_AUTO_TEST_CASE(adhesion_holds_below_its_speed_and_lets_go_above) {
  for (const double restitution : {1.0, 0.9}) {
    AdhesionCase slow = adhesion_case("jkr", 0.97), fast = adhesion_case("jkr", 1.6);
    slow.restitution = fast.restitution = restitution;
    const double step = default_step(fast) / 4;
    BOOST_TEST(!marched_adhesion(slow, step, 0.35).parted);
    const AdhesionOutcome found = marched_adhesion(fast, step, 0.35);
    BOOST_TEST(found.parted);
    if (restitution < 1) continue;
    const reference::HertzPair pair = hertz_pair_of(fast);
    const double pull = reference::jkr_pull_off(pair, fast.work_of_adhesion);
    BOOST_TEST(found.work_off < 1e-10);
    BOOST_TEST(found.first_force / pull == -8.0 / 9, boost::test_tools::tolerance(0.03));
    BOOST_TEST(found.restitution == std::sqrt(1 - 1 / (1.6 * 1.6)), boost::test_tools::tolerance(3e-3));
    BOOST_TEST(found.taken == reference::jkr_cycle_loss(pair, fast.work_of_adhesion),
               boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_SUITE_END()
