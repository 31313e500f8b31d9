// Chains in shear against Jeffery's orbits: period, direction, finite stiffness, inertia.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/flow/inertia.hpp"
#include "compare/flow/study.hpp"
#include "dem/model/errors.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"
#include "reference/rigid_chain_mobility.hpp"

BOOST_AUTO_TEST_SUITE(flow_orbit_test)

namespace compare = fiberchain::compare;
namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;

BOOST_AUTO_TEST_CASE(periods_of_odd_chains_are_jefferys) {
  std::vector<compare::OrbitCase> cases;
  for (const int N : {2, 3, 7, 12, 33, 101}) {
    cases.push_back({.spheres = N, .elasto_viscous = 0.013, .tolerance = 1e-10, .poisson_ratio = 0.17});
  }
  for (const auto& p : compare::orbit_points(cases)) {
    const double exact = reference::jeffery_period(reference::free_draining_aspect_ratio(p.asked.spheres), 1);
    BOOST_TEST(std::abs(p.period / exact - 1) < 1e-5,
               "N = " << p.asked.spheres << ": " << p.period << ", " << exact);
    BOOST_TEST(p.status == "finished");
  }
}

BOOST_AUTO_TEST_CASE(the_table_of_periods_knows_its_references_and_their_ranges) {
  const auto study = compare::period_study({.spheres = {3, 20}, .interacting = {7}, .stresslets = {6}}, {});
  BOOST_REQUIRE_EQUAL(study.table.rows().size(), 4u);
  BOOST_TEST(study.failed == 0);
  BOOST_TEST(std::isnan(study.table.number(0, "period_cox")));  // r_e > r below 4.65
  BOOST_CHECK_CLOSE_FRACTION(study.table.number(1, "period_cox"),
                             reference::jeffery_period(1.24 * 20 / std::sqrt(std::log(20)), 1), 1e-12);
  BOOST_CHECK_CLOSE_FRACTION(
      study.table.number(1, "over_goldsmith_mason"),
      study.table.number(1, "period") / reference::jeffery_period(0.742 * 20 - 0.0017 * 400, 1) - 1, 1e-9);
  BOOST_CHECK_CLOSE_FRACTION(study.table.number(2, "period"),
                             reference::rigid_chain_period({7, reference::ChainCoupling::force_torque}, 1),
                             1e-5);
  BOOST_CHECK_CLOSE_FRACTION(
      study.table.number(3, "period"),
      reference::rigid_chain_period({6, reference::ChainCoupling::force_torque_stresslet}, 1), 1e-5);
}

BOOST_AUTO_TEST_CASE(orbits_out_of_the_plane_follow_the_closed_form) {
  for (const auto& run : compare::jeffery_runs(6, 1, {0.13, 0.61, 1}, {})) {
    BOOST_TEST(run.distance < 1e-5);
    BOOST_TEST(run.drift < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(finite_stiffness_is_felt_in_the_second_order) {
  for (const int N : {2, 4}) {
    const auto points = compare::stiffness_points(N, {2e-4, 6e-4, 2e-3}, {});
    BOOST_TEST(std::isnan(points[0].order));
    for (std::size_t i = 1; i < points.size(); ++i) BOOST_TEST(std::abs(points[i].order - 2) < 0.02);
  }
}

BOOST_AUTO_TEST_CASE(inertia_is_felt_in_the_first_order_and_takes_the_fiber_toward_the_flow_plane) {
  const compare::InertiaCase coarse{.spheres = 9, .stokes = 0.02, .method = dem::FlowMethod::leapfrog},
      fine{.spheres = 9, .stokes = 0.005, .method = dem::FlowMethod::leapfrog};
  const double order =
      std::log(compare::inertia_distance(coarse) / compare::inertia_distance(fine)) / std::log(4.0);
  BOOST_TEST(std::abs(order - 1) < 0.05);
  const double bending = compare::orbit_drift({.spheres = 9, .tolerance = 1e-10}, 1);
  const double with = compare::orbit_drift(coarse, 1) - bending,
               less = compare::orbit_drift(fine, 1) - bending;
  BOOST_TEST(with > 0);
  BOOST_TEST(std::abs(with / less - 4) < 0.3);
}

BOOST_AUTO_TEST_CASE(a_case_out_of_range_is_refused) {
  BOOST_CHECK_THROW(compare::orbit_points({{.spheres = 1}}), std::exception);
  BOOST_CHECK_THROW(compare::orbit_points({{.elasto_viscous = 0}}), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
