// Where a fiber in a flow starts, and what is measured of its history.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "compare/flow/setup.hpp"
#include "compare/flow/turn_detection.hpp"
#include "compare/scenes/flow_report.hpp"
#include "reference/jeffery.hpp"

BOOST_AUTO_TEST_SUITE(flow_measures_test)

namespace compare = fiberchain::compare;
namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;

namespace {

constexpr double pi = std::numbers::pi;

dem::FlowStart bent(std::array<double, 3> along, std::array<double, 3> across, double bend, double s_bend) {
  return {along, bend, s_bend, across};
}

/// Jeffery's closed form as a history.
std::vector<compare::FlowMoment> jeffery_history(double aspect_ratio, const reference::Direction& start,
                                                 double strain, double interval) {
  const auto orbit = reference::jeffery_orbit(aspect_ratio, 1, start);
  const double Lambda = reference::bretherton_constant(aspect_ratio);
  std::vector<compare::FlowMoment> moments;
  for (double t = 0; t <= strain; t += interval) {
    const auto p = reference::direction_on_orbit(orbit, t);
    moments.push_back({t, p, reference::jeffery_rate(Lambda, reference::simple_shear(1), p), {}, 1, 0, 0});
  }
  return moments;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_bent_start_keeps_bonds_and_center_and_has_the_height_asked_for) {
  const dem::Fiber fiber = compare::fiber_of_spheres(41, 0.17);
  const double L = dem::fiber_length(fiber), l = dem::bond_length(fiber);
  const auto poses = dem::start_poses<3>(fiber, bent({-0.6, 0, 0.8}, {0.8, 0, 0.6}, 0.01, 0));
  dem::Vec<double, 3> sum{};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    sum = sum + poses[i].position;
    if (i > 0) BOOST_TEST(std::abs(dem::norm(poses[i].position - poses[i - 1].position) / l - 1) < 1e-14);
  }
  BOOST_TEST(dem::norm(sum) < 1e-12 * L);
  const auto rise = poses[20].position - 0.5 * (poses[0].position + poses[40].position);
  BOOST_TEST(std::abs((0.8 * rise[0] + 0.6 * rise[2]) / L - 0.01) < 2e-5);
  BOOST_TEST(std::abs(rise[1]) < 1e-15);
  // a parabola bends every bond alike and shears none
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double bend = 8 * 0.01 / 40;
  BOOST_TEST(std::abs(dem::elastic_energy<3>(chain, poses) /
                          (40 * 0.5 * dem::bond_stiffness(fiber).bend * bend * bend) -
                      1) < 1e-6);
}

BOOST_AUTO_TEST_CASE(planar_and_spatial_starts_agree_whichever_way_the_fiber_points) {
  const dem::Fiber fiber = compare::fiber_of_spheres(8);
  for (const double angle : {0.3, 1.9, -2.8, pi}) {
    for (const double side : {1.0, -1.0}) {
      const auto start = bent({std::cos(angle), std::sin(angle), 0},
                              {-side * std::sin(angle), side * std::cos(angle), 0}, 0.03, -0.02);
      const auto flat = dem::start_poses<2>(fiber, start);
      const auto space = dem::start_poses<3>(fiber, start);
      const double energy = dem::elastic_energy<2>(dem::straight_chain<2>(fiber), flat);
      BOOST_TEST(std::abs(dem::elastic_energy<3>(dem::straight_chain<3>(fiber), space) / energy - 1) < 1e-10);
      for (std::size_t i = 0; i < flat.size(); ++i) {
        const auto a = dem::axis(flat[i]);
        const auto b = dem::axis(space[i]);
        BOOST_TEST(std::hypot(a[0] - b[0], a[1] - b[1], b[2]) < 1e-12);
        BOOST_TEST(std::hypot(flat[i].position[0] - space[i].position[0],
                              flat[i].position[1] - space[i].position[1]) < 1e-15);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_elasto_viscous_number_is_that_of_its_formula) {
  const dem::Fiber fiber = compare::fiber_of_spheres(13, 0.17);
  const double mu = compare::viscosity_of(fiber, 321, 0.7);
  BOOST_CHECK_CLOSE_FRACTION(compare::elasto_viscous_number(fiber, mu, 0.7), 321, 1e-14);
  // 192 N^4 mu rate/E
  BOOST_CHECK_CLOSE_FRACTION(192 * std::pow(13, 4) * mu * 0.7 / fiber.material.youngs_modulus, 321, 1e-13);
}

BOOST_AUTO_TEST_CASE(half_turns_of_jefferys_closed_form_are_found_to_the_order_of_the_cubic) {
  const double r = 6.3, half = reference::jeffery_period(r, 1) / 2;
  double before = 0;
  for (const double interval : {0.2, 0.1}) {
    const auto moments = jeffery_history(r, {0.4, 0.7, 0.5}, 3.3 * half, interval);
    const auto times = compare::half_turns(moments);
    BOOST_REQUIRE_EQUAL(times.size(), 3u);
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k)
      worst = std::max(worst, std::abs(times[k] - static_cast<double>(k + 1) * half));
    BOOST_TEST(worst < (interval == 0.2 ? 2e-4 : 2e-5));
    if (before > 0)
      BOOST_TEST(before / worst > 4);  // at least second order where crossings fall anywhere between
    before = worst;
    BOOST_TEST(std::abs(compare::orbit_period(moments) / (2 * half) - 1) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(phases_run_on_and_either_way) {
  std::vector<compare::FlowMoment> moments;
  for (int i = 0; i <= 100; ++i) {
    const double angle = 1 - 0.17 * i;
    moments.push_back({0.5 * i,
                       {std::sin(angle), std::cos(angle), 0},
                       {-0.34 * std::cos(angle), 0.34 * std::sin(angle), 0},
                       {},
                       1,
                       0,
                       0});
  }
  const auto phase = compare::phases(moments);
  BOOST_TEST(std::abs(phase.back() - (1 - 17.0)) < 1e-12);
  const auto times = compare::half_turns(moments);
  BOOST_REQUIRE_EQUAL(times.size(), 5u);
  BOOST_TEST(std::abs(times[4] - 5 * pi / 0.34) < 1e-9);
  moments.resize(5);
  BOOST_TEST(std::isnan(compare::orbit_period(moments)));
}

BOOST_AUTO_TEST_CASE(a_scene_without_a_turn_has_no_period_and_orbits_have_their_hydrodynamics) {
  dem::FlowScene scene{};
  scene.fiber = compare::fiber_of_spheres(5, 0.17);
  scene.fluid = {compare::viscosity_of(scene.fiber, 1, 1), {dem::planar_extension(1)}};
  scene.rate = 1;
  scene.duration = 1;
  scene.samples = 20;
  scene.shapes = 4;
  const compare::FlowHistory history = compare::run_flow(scene);
  BOOST_TEST(history.moments.size() == 21u);
  BOOST_TEST(history.shapes.size() == 5u);
  const dem::Table row = compare::flow_table(scene, history);
  BOOST_TEST(std::isnan(row.number(0, "period")));
  BOOST_TEST(std::isnan(row.number(0, "orbit_constant")));
  BOOST_CHECK_CLOSE_FRACTION(row.number(0, "elasto_viscous"), 1, 1e-12);
  BOOST_TEST(compare::flow_history_table(scene, history).rows().size() == 21u);
  BOOST_TEST(compare::flow_shapes_table(scene, history).rows().size() == 25u);
  BOOST_TEST(compare::flow_scene_figures(scene, history).size() == 2u);
  BOOST_CHECK_CLOSE_FRACTION(compare::scene_aspect_ratio(scene), std::sqrt(13.0), 1e-14);
  scene.fluid.hydrodynamics = dem::Hydrodynamics::interactions;
  const double r = compare::scene_aspect_ratio(scene);
  BOOST_TEST(std::abs(2 * pi * (r + 1 / r) - 28.7686) < 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
