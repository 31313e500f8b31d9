// What fibers do to walls that turn, swing and are driven: impulses, work, neighbors, saved states.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/contact/contact_law.hpp"
#include "tests/dem/mill.hpp"

BOOST_AUTO_TEST_SUITE(wall_forces_test)

namespace dem = fiberchain::dem;
using namespace walls_in_motion;

namespace {

Mill exact_mill() {
  const V y{0, 1, 0};
  return Mill({.drum = {dem::Cylinder{{}, y, 0.02}},
               .left = {dem::Plane{{0, -0.012, 0}, y}},
               .lid = {dem::Plane{{0, 0.012, 0}, -y}},
               .paddle = {dem::BoxObstacle{{0, 0, -15e-3}, {1e-3, 6e-3, 3e-3}, {1, 0, 0}, y}},
               .funnel = {dem::Cone{{0, 0, 14.5e-3}, {0, 0, -1}, 4e-3, 7e-3, 3e-3, 2e-4}},
               .more = {{dem::Sphere{{-12.5e-3, 0, 0}, 2.5e-3, -1}}}});
}

}  // namespace

/// Impulses of all walls and the weight's are the change of momentum, in every interval.
BOOST_AUTO_TEST_CASE(impulses_of_walls_are_the_change_of_momentum) {
  const Mill mill = exact_mill();
  dem::Assembly assembly = mill.assembly(4e-6);
  march_and_weigh(mill, assembly);
}

/// What is given by walls that turn, swing and are driven closes the energy, impacts and all.
BOOST_AUTO_TEST_CASE(energy_with_moving_walls_closes) {
  double off[2], given = 0;
  for (int n = 0; n < 2; ++n) {
    const Mill mill = exact_mill();
    dem::Assembly assembly = mill.assembly(n == 0 ? 2e-6 : 1e-6, true);
    const double begin = total(assembly.energy());
    const int steps = n == 0 ? 10000 : 20000;
    assembly.march(steps);
    const dem::EnergyBalance now = assembly.energy();
    double of_walls = 0;
    for (const dem::WallSample& sample : assembly.wall_samples()) of_walls += sample.work;
    within(of_walls / now.wall_work, 1, 1e-12, "sum of the walls' work");
    given = std::abs(now.wall_work) + std::abs(now.contact_tangential);
    off[n] = (total(now) - begin) / given;
    BOOST_TEST_MESSAGE("total energy off by " << off[n] << " of what walls gave");
  }
  BOOST_TEST(std::abs(off[0]) < 1e-4);
  BOOST_TEST(std::abs(off[1]) < 0.5 * std::abs(off[0]));
}

/// The list keeps up with walls that turn: every sphere in a wall is one of its contacts.
BOOST_AUTO_TEST_CASE(no_sphere_at_a_turning_wall_is_missed) {
  Mill mill = exact_mill();
  mill.around.walls[3].motion.angular_velocity = -150;
  dem::Assembly assembly = mill.assembly(3e-6);
  std::int64_t seen = 0;
  for (int n = 0; n < 400; ++n) {
    assembly.march(97);
    std::int64_t expected = 0, found = 0;
    const dem::PlacedSpheres all = assembly.placed();
    for (const dem::Wall& wall : assembly.walls()) {
      for (std::size_t i = 0; i < all.radius.size(); ++i)
        expected += gap_to(wall, all.position[i], assembly.time()) < all.radius[i] ? 1 : 0;
    }
    for (const auto& contact : assembly.contacts()) found += is_facet(contact.key.second) ? 1 : 0;
    BOOST_TEST(found == expected);
    seen += found;
  }
  BOOST_TEST(seen > 100);
}

/// A run restored amid an interval, walls turning and driven, goes on to the bit; so does one on two threads.
BOOST_AUTO_TEST_CASE(restored_runs_with_moving_walls_go_on_to_the_bit) {
  const Mill mill = exact_mill();
  dem::Assembly whole = mill.assembly(3e-6, true), other = mill.assembly(3e-6, true, 2);
  whole.march(3000);
  whole.begin_wall_interval();
  whole.march(700);
  other.restore(whole.saved());
  march_alike(whole, other, 1300);
  BOOST_TEST(norm(whole.wall_samples()[2].center - mill.around.walls[2].shape.point()) >
             1e-5);  // the lid has moved
}

BOOST_AUTO_TEST_SUITE_END()
