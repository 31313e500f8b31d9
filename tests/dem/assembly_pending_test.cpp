// What an assembly does not do yet. Not in the build: each test moves to where it belongs once it passes.
#define BOOST_TEST_MODULE assembly_pending
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/errors.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/small_packing.hpp"

using namespace scenes;

namespace {

dem::FiberGroup stirred(double damping, double speed) {
  dem::Fiber fiber = odd_fiber(7);
  fiber.bond_damping = damping;
  return scattered(dem::straight_chain<3>(fiber), 5, speed, 7);
}

}  // namespace

/// Moves to energy_balance_test: 0.1 % at the step that is chosen.
BOOST_AUTO_TEST_CASE(the_balance_of_a_packing_closes_to_a_thousandth) {
  for (const bool periodic : {false, true}) {
    for (const double damping : {0.1, 0.3}) {
      SmallPacking packing = periodic ? packing_in_a_periodic_box(24, 15) : packing_in_a_box(24, 15);
      for (auto& group : packing.groups) group.chain.fiber.bond_damping = damping;
      dem::Assembly assembly = packing.assembly({.book_energy = true});
      const dem::EnergyBalance start = assembly.energy();
      for (int n = 0; n < 10; ++n) {
        assembly.march(static_cast<int>(2.4e-3 / assembly.step()));
        const dem::EnergyBalance now = assembly.energy();
        const double turned = start.kinetic + start.gravity - now.gravity + now.wall_work;
        BOOST_TEST(std::abs(total(now) - total(start)) < 1e-3 * turned, (total(now) - total(start)) / turned
                                                                            << " at " << assembly.time()
                                                                            << " s, xi_b = " << damping);
      }
    }
  }
}

/// Moves to energy_balance_test: what is booked is booked up to this moment, as the kinetic energy is of this
/// moment, also where dashpots take much within a step.
BOOST_AUTO_TEST_CASE(what_is_taken_is_booked_up_to_the_moment_of_the_velocities) {
  const dem::FiberGroup group = stirred(0.2, 0.02);
  dem::Assembly assembly({group}, {},
                         {.step = 0.02 * dem::stable_time_step(group.chain.fiber), .book_energy = true});
  const dem::EnergyBalance start = assembly.energy();
  for (int n = 0; n < 20; ++n) {
    assembly.march(10);
    const double off = (total(assembly.energy()) - total(start)) / start.kinetic;
    BOOST_TEST(std::abs(off) < 1e-3, off);
  }
}

/// Moves to assembly_physics_test.
BOOST_AUTO_TEST_CASE(the_velocities_at_the_start_are_those_given) {
  for (const double damping : {0.0, 0.4}) {
    const dem::FiberGroup group = stirred(damping, 0.02);
    const dem::Assembly assembly({group}, {}, {});
    double off = 0, size = 0;
    for (int f = 0; f < 5; ++f) {
      for (std::size_t i = 0; i < 8; ++i) {
        off = std::max(off, norm(assembly.state(0, f).velocity[i] - group.fibers[f].velocity[i]));
        size = std::max(size, norm(group.fibers[f].velocity[i]));
      }
    }
    BOOST_TEST(off < 1e-3 * size, "xi_b = " << damping << ": off by " << off / size);
  }
}

/// Moves to assembly_test: the images of a sphere would have to move with the flow.
BOOST_AUTO_TEST_CASE(a_flow_that_varies_across_periodic_sides_is_refused) {
  const dem::FiberGroup group = stirred(0, 0.01);
  dem::Surroundings around;
  around.fluid = dem::Fluid{1e-3, {dem::simple_shear(3)}};  // u_x = 3 y
  around.period = {2, 0, 2};
  BOOST_CHECK_NO_THROW(dem::Assembly({group}, around, {}));
  around.period = {0, 2, 0};
  BOOST_CHECK_THROW(dem::Assembly({group}, around, {}), dem::InvalidInput);
}

/// Moves to assembly_test: as assembly.hpp says.
BOOST_AUTO_TEST_CASE(spheres_beyond_a_wall_and_unstable_steps_are_refused) {
  const dem::FiberGroup group = stirred(0, 0.01);
  dem::Surroundings around;
  around.walls = {side({0, 0, 3}, {0, 0, 1})};
  BOOST_CHECK_THROW(dem::Assembly({group}, around, {}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::Assembly({group}, {}, {.step = 1.5 * dem::stable_time_step(group.chain.fiber)}),
                    dem::InvalidInput);
}
