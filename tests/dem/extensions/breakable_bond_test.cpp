#define BOOST_TEST_MODULE breakable_bond
#include <boost/test/unit_test.hpp>

#include "dem/assembly/packing_law.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/assembly/assembly_scenes.hpp"
#include "tests/dem/extensions/breakable_bond.hpp"

// Bonds that break: the flag is part of the history.
namespace dem = fiberchain::dem;
using scenes::V;

namespace {

dem::AssemblyOptions breakable() { return {.law = &dem::outside_law<dem::breakable_form>}; }

/// Fibers of three bonds apart from each other, the last sphere of each flying off along the axis: faster
/// from fiber to fiber.
dem::FiberGroup pulled(double strength, double slowest, int count) {
  dem::Fiber fiber = scenes::odd_fiber(3);
  fiber.law_parameters.back() = strength;
  dem::FiberGroup group{dem::straight_chain<3>(fiber), {}};
  for (int f = 0; f < count; ++f) {
    dem::ChainState<3> state = dem::at_rest<3>(group.chain.poses);
    scenes::move(state, {0, 5.0 * f * fiber.diameter, 0});
    state.velocity[3] = {slowest * (1 + f), 0, 0};
    group.fibers.push_back(state);
  }
  return group;
}

constexpr double never = 1e300;

}  // namespace

BOOST_AUTO_TEST_CASE(no_bond_breaks_below_its_strength_and_the_motion_is_that_of_the_plain_law) {
  const dem::FiberGroup group = pulled(never, 0.02, 4);
  dem::Assembly plain({group}, {}, {}), strong({group}, {}, breakable());
  plain.march(500), strong.march(500);
  for (int f = 0; f < 4; ++f) {
    for (int i = 0; i < 3; ++i) BOOST_TEST(!strong.is_broken(0, f, i));
    for (int i = 0; i < 4; ++i) {
      BOOST_TEST(norm(plain.state(0, f).poses[i].position - strong.state(0, f).poses[i].position) < 1e-12);
    }
  }
}

// The first pull reaches N = v sqrt(K_n m) times a number between 1/2 and 1: a strength far below breaks it,
// far above not.
BOOST_AUTO_TEST_CASE(bond_breaks_once_its_tension_exceeds_the_strength_and_the_sphere_flies_free) {
  const dem::Fiber fiber = scenes::odd_fiber(3);
  const double speed = 0.05,
               pull = speed * std::sqrt(dem::bond_stiffness(fiber).stretch * dem::sphere_mass(fiber));
  dem::Assembly assembly({pulled(2 * pull, speed, 6)}, {}, breakable());
  assembly.march(2000);
  BOOST_TEST(!assembly.is_broken(0, 0, 2));  // at most `pull`
  BOOST_TEST(assembly.is_broken(0, 5, 2));   // 6 times as fast: at least 3 times `pull`
  const auto bonds = assembly.bonds(0, 5);
  BOOST_TEST(norm(bonds[2].force) == 0);
  const V before = assembly.state(0, 5).velocity[3];
  assembly.march(1000);
  BOOST_TEST(norm(assembly.state(0, 5).velocity[3] - before) < 1e-12 * norm(before));
}

BOOST_AUTO_TEST_CASE(broken_bonds_are_kept_through_save_and_restore) {
  const dem::FiberGroup group = pulled(never, 0.02, 11);
  dem::Assembly assembly({group}, {}, breakable()), again({group}, {}, breakable());
  assembly.march(20);
  assembly.break_bond(0, 4, 1), assembly.break_bond(0, 10, 0);
  assembly.march(20);
  again.restore(assembly.saved());
  for (int f = 0; f < 11; ++f) {
    for (int i = 0; i < 3; ++i) {
      BOOST_TEST(assembly.is_broken(0, f, i) == ((f == 4 && i == 1) || (f == 10 && i == 0)));
      BOOST_TEST(again.is_broken(0, f, i) == assembly.is_broken(0, f, i));
    }
  }
  assembly.march(50), again.march(50);
  BOOST_TEST(norm(again.state(0, 4).poses[3].position - assembly.state(0, 4).poses[3].position) == 0);
}

BOOST_AUTO_TEST_CASE(laws_without_broken_bonds_refuse) {
  dem::Assembly plain({pulled(never, 0.02, 1)}, {}, {});
  BOOST_CHECK_THROW(plain.break_bond(0, 0, 1), dem::InvalidInput);
  BOOST_TEST(!plain.is_broken(0, 0, 1));
  dem::AssemblyOptions accounted = breakable();
  accounted.account_energy = true;
  BOOST_CHECK_THROW(dem::Assembly({pulled(never, 0.02, 1)}, {}, accounted), dem::InvalidInput);
}
