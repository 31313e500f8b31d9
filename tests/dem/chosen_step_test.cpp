// The step that is chosen: the coefficient of restitution it keeps, and the speeds it counts.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/assembly/assembly.hpp"
#include "dem/contact/restitution_error.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/model/errors.hpp"

BOOST_AUTO_TEST_SUITE(chosen_step_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

namespace {

/// Two bonded spheres that fall broadside on a floor: each meets it alone.
struct Drop {
  double restitution, speed;
  double allowed = dem::usual_restitution_error;
  double height = 1.07e-3;  ///< of the centers at the start [m]

  dem::Fiber fiber() const { return {dem::isotropic_material(37e6, 0.17, 1310), 1.7e-3, 1}; }
  dem::Domain around() const {
    dem::Domain domain;
    domain.walls.push_back({dem::Plane{{}, {0, 0, 1}}});
    domain.wall_youngs_modulus = 21e6;
    domain.contacts = {restitution, 0, 0};
    return domain;
  }
  dem::Assembly assembly() const {
    const auto chain = dem::straight_chain<3>(fiber());
    const auto state = dem::placed(chain, dem::FiberStart{{0, 0, height}, {0, 1, 0}, {0, 0, -speed}});
    dem::AssemblyOptions options;
    options.restitution_error = allowed;
    return {{{chain, {state}}}, around(), options};
  }
  double rebound() const {
    dem::Assembly falling = assembly();
    while (falling.steps() < 100000) {
      falling.march(1);
      const double up = falling.state(0, 0).velocity[0][2];
      if (up > 0 && falling.touching() == 0) return up / speed;
    }
    return 0;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(it_keeps_the_coefficient_of_restitution_to_what_is_allowed) {
  for (const double e : {0.25, 0.3, 0.4, 0.55, 0.8, 1.0}) {
    for (const double speed : {0.3, 3.0}) {
      for (const double height : {0.9e-3, 0.93e-3, 1.07e-3}) {  // moments of touch within a step
        const Drop drop{e, speed, dem::usual_restitution_error, height};
        BOOST_TEST(std::abs(drop.rebound() - e) < dem::usual_restitution_error,
                   e << " at " << speed << " m/s from " << height << ": " << drop.rebound());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(less_error_takes_a_shorter_step_and_what_is_said_bounds_it) {
  const Drop usual{0.4, 1.1}, fine{0.4, 1.1, 0.002};
  const double step = fine.assembly().step();
  BOOST_TEST(step < 0.6 * usual.assembly().step());
  BOOST_TEST(std::abs(fine.rebound() - 0.4) < 0.002);
  const auto chain = dem::straight_chain<3>(fine.fiber());
  const double said = dem::restitution_error({{chain, {}}}, fine.around(), 1.1, step);
  BOOST_TEST(said <= 0.002);
  BOOST_TEST(said > 0.0005);
  const auto body = dem::sphere_body(fine.fiber(), {});
  BOOST_CHECK_THROW(dem::step_for_restitution(body, body, {0.4, 0, 0}, 1, 0, 1e-5), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(the_fastest_sphere_goes_a_tenth_of_a_radius) {
  const Drop fast{1.0, 230};
  dem::StepChoice choice =
      dem::assembly_time_step({{dem::straight_chain<3>(fast.fiber()), {}}}, fast.around(), {.speed = 230});
  BOOST_TEST(choice.set_by == "speed");
  BOOST_CHECK_CLOSE_FRACTION(choice.step, 0.1 * 0.85e-3 / 230, 1e-12);
  BOOST_TEST(fast.assembly().step() == choice.step);
  // walls that come upon fibers count
  dem::Domain around = fast.around();
  around.walls[0].velocity = {0, 0, 230};
  choice = dem::assembly_time_step({{dem::straight_chain<3>(fast.fiber()), {}}}, around, {});
  BOOST_CHECK_CLOSE_FRACTION(choice.step, 0.1 * 0.85e-3 / 230, 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
