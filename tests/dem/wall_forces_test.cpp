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
#include "dem/insertion/placement.hpp"
#include "tests/dem/walls_in_motion.hpp"

BOOST_AUTO_TEST_SUITE(wall_forces_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;
using namespace walls_in_motion;

namespace {

V momentum(const dem::Assembly& assembly) {
  V sum{};
  for (int group = 0; group < assembly.groups(); ++group) {
    const double m = dem::sphere_mass(assembly.chain(group).fiber);
    for (int f = 0; f < assembly.fibers(group); ++f)
      for (const V& v : assembly.state(group, f).velocity) sum = sum + m * v;
  }
  return sum;
}

/// A turning drum with a paddle in it, a shaken funnel, a driven lid, fibers among them.
struct Mill {
  dem::Domain around;
  dem::FiberGroup fibers;

  explicit Mill(double friction = 0.35) {
    around.gravity = {0, 0.3, -g};
    around.contacts = {.restitution = 0.5, .friction = friction, .rolling_friction = 0.03};
    around.wall_youngs_modulus = 5e6;
    const V y{0, 1, 0};
    dem::Wall drum{dem::Cylinder{{}, y, 0.02}}, left{dem::Plane{{0, -0.012, 0}, y}},
        lid{dem::Plane{{0, 0.012, 0}, -y}},
        paddle{dem::BoxObstacle{{0, 0, -15e-3}, {1e-3, 6e-3, 3e-3}, {1, 0, 0}, y}},
        funnel{dem::Cone{{0, 0, 14.5e-3}, {0, 0, -1}, 4e-3, 7e-3, 3e-3, 2e-4}},
        ball{dem::Sphere{{-12.5e-3, 0, 0}, 2.5e-3, -1}};
    drum.motion.about = left.motion.about = dem::WallAxis{{}, y};
    paddle.motion.about = dem::WallAxis{paddle.shape.point(), y};
    drum.motion.angular_velocity = left.motion.angular_velocity = 21;
    paddle.motion.angular_velocity = -9;
    funnel.motion.oscillation = dem::WallOscillation{{0.6, 0, 0.8}, 4e-4, 70, 0.3, 0.01};
    lid.motion.drive = dem::WallDrive{.axis = -y, .mass = 2e-4, .force = 3e-3, .damping = 0.01};
    around.walls = {drum, left, lid, paddle, funnel, ball};
    const dem::Fiber fiber = fiber_with(5);
    fibers.chain = dem::straight_chain<3>(fiber);
    for (int n = 0; n < 12; ++n) {
      const double angle = 0.25 + 2 * pi * n / 12;
      fibers.fibers.push_back(
          dem::placed(fibers.chain,
                      {{0.0165 * std::cos(angle), -4e-3, 0.0165 * std::sin(angle)}, y, {0.1, -0.05, 0.02}}));
    }
  }

  dem::Assembly assembly(double step, bool accounted = false, int threads = 1) const {
    return {{fibers}, around, {.step = step, .threads = threads, .account_energy = accounted}};
  }
};

}  // namespace

/// Impulses of all walls and the weight's are the change of momentum, in every interval.
BOOST_AUTO_TEST_CASE(impulses_of_walls_are_the_change_of_momentum) {
  const Mill mill;
  dem::Assembly assembly = mill.assembly(4e-6);
  const double m = 12 * dem::fiber_mass(mill.fibers.chain.fiber);
  V before = momentum(assembly);
  double then = 0, largest = 0;
  std::vector<double> seen(mill.around.walls.size(), 0);
  for (int n = 0; n < 40; ++n) {
    assembly.march(n % 3 == 0 ? 1811 : 957);
    const double T = assembly.time() - then;
    V impulse = (m * T) * mill.around.gravity;
    double size = norm(impulse);
    const auto samples = assembly.wall_samples();
    for (std::size_t w = 0; w < samples.size(); ++w) {
      impulse = impulse - T * samples[w].mean.force;
      size += T * samples[w].force_peak;
      seen[w] = std::max(seen[w], samples[w].force_peak);
      BOOST_TEST(norm(samples[w].mean.force) <= samples[w].force_peak * (1 + 1e-12));
      BOOST_TEST(norm(samples[w].mean.moment) <= samples[w].moment_peak * (1 + 1e-12));
    }
    const V now = momentum(assembly);
    const double off = norm(now - before - impulse) / (size + m * 0.3);
    largest = std::max(largest, off);
    before = now, then = assembly.time();
    assembly.begin_wall_interval();
  }
  BOOST_TEST_MESSAGE("impulses off by " << largest << " of their sizes");
  BOOST_TEST(largest < 1e-12);
  for (std::size_t w = 0; w < seen.size(); ++w) BOOST_TEST(seen[w] > 0.0, "wall " << w << " was not touched");
}

/// What is given by walls that turn, swing and are driven closes the energy, impacts and all.
BOOST_AUTO_TEST_CASE(energy_with_moving_walls_closes) {
  double off[2], given = 0;
  for (int n = 0; n < 2; ++n) {
    const Mill mill;
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
  Mill mill;
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
  const Mill mill;
  dem::Assembly whole = mill.assembly(3e-6, true), other = mill.assembly(3e-6, true, 2);
  whole.march(3000);
  whole.begin_wall_interval();
  whole.march(700);
  other.restore(whole.saved());
  for (dem::Assembly* assembly : {&whole, &other}) assembly->march(1300);
  const auto a = whole.wall_samples(), b = other.wall_samples();
  for (std::size_t w = 0; w < a.size(); ++w) {
    for (int c = 0; c < 3; ++c) {
      BOOST_TEST(a[w].mean.force[c] == b[w].mean.force[c]);
      BOOST_TEST(a[w].mean.moment[c] == b[w].mean.moment[c]);
      BOOST_TEST(a[w].center[c] == b[w].center[c]);
    }
    BOOST_TEST(a[w].force_peak == b[w].force_peak);
    BOOST_TEST(a[w].work == b[w].work);
  }
  const dem::PlacedSpheres x = whole.placed(), y = other.placed();
  for (std::size_t i = 0; i < x.position.size(); ++i) {
    for (int c = 0; c < 3; ++c) BOOST_TEST_REQUIRE(x.position[i][c] == y.position[i][c]);
  }
  BOOST_TEST(norm(a[2].center - mill.around.walls[2].shape.point()) > 1e-5);  // the lid has moved
}

BOOST_AUTO_TEST_SUITE_END()
