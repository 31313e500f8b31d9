#pragma once

#include <algorithm>
#include <vector>

#include "dem/insertion/placement.hpp"
#include "tests/dem/walls_in_motion.hpp"

/// Fibers among walls of every motion, and what holds for them whatever the walls' shapes.
namespace walls_in_motion {

using V = dem::Vec<double, 3>;

/// A turning drum about y, its end plate, a driven lid, a paddle in it, a shaken funnel; further ones stand.
struct MillWalls {
  dem::Wall drum, left, lid, paddle, funnel;
  std::vector<dem::Wall> more = {};
};

struct Mill {
  dem::Domain around;
  dem::FiberGroup fibers;

  explicit Mill(MillWalls walls, double friction = 0.35) {
    around.gravity = {0, 0.3, -g};
    around.contacts = {.restitution = 0.5, .friction = friction, .rolling_friction = 0.03};
    around.wall_youngs_modulus = 5e6;
    const V y{0, 1, 0};
    walls.drum.motion.about = walls.left.motion.about = dem::WallAxis{{}, y};
    walls.drum.motion.angular_velocity = walls.left.motion.angular_velocity = 21;
    walls.paddle.motion.about = dem::WallAxis{walls.paddle.shape.point(), y};
    walls.paddle.motion.angular_velocity = -9;
    walls.funnel.motion.oscillation = dem::WallOscillation{{0.6, 0, 0.8}, 4e-4, 70, 0.3, 0.01};
    walls.lid.motion.drive = dem::WallDrive{.axis = -y, .mass = 2e-4, .force = 3e-3, .damping = 0.01};
    around.walls = {walls.drum, walls.left, walls.lid, walls.paddle, walls.funnel};
    around.walls.insert(around.walls.end(), walls.more.begin(), walls.more.end());
    fibers.chain = dem::straight_chain<3>(fiber_with(5));
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

inline V momentum(const dem::Assembly& assembly) {
  V sum{};
  const double m = dem::sphere_mass(assembly.chain(0).fiber);
  for (int f = 0; f < assembly.fibers(0); ++f)
    for (const V& v : assembly.state(0, f).velocity) sum = sum + m * v;
  return sum;
}

/// Marches through 40 intervals, in each of which the impulses of all walls and the weight's are the change
/// of momentum; every wall is touched.
inline void march_and_weigh(const Mill& mill, dem::Assembly& assembly) {
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
    largest = std::max(largest, norm(now - before - impulse) / (size + m * 0.3));
    before = now, then = assembly.time();
    assembly.begin_wall_interval();
  }
  BOOST_TEST_MESSAGE("impulses off by " << largest << " of their sizes");
  BOOST_TEST(largest < 1e-12);
  for (std::size_t w = 0; w < seen.size(); ++w) BOOST_TEST(seen[w] > 0.0, "wall " << w << " was not touched");
}

/// Marches both on; every number of them stays the same to the bit.
inline void march_alike(dem::Assembly& one, dem::Assembly& other, int steps) {
  for (dem::Assembly* assembly : {&one, &other}) assembly->march(steps);
  const auto a = one.wall_samples(), b = other.wall_samples();
  for (std::size_t w = 0; w < a.size(); ++w) {
    for (int c = 0; c < 3; ++c) {
      BOOST_TEST(a[w].mean.force[c] == b[w].mean.force[c]);
      BOOST_TEST(a[w].mean.moment[c] == b[w].mean.moment[c]);
      BOOST_TEST(a[w].center[c] == b[w].center[c]);
    }
    BOOST_TEST(a[w].force_peak == b[w].force_peak);
    BOOST_TEST(a[w].work == b[w].work);
  }
  const dem::PlacedSpheres x = one.placed(), y = other.placed();
  for (std::size_t i = 0; i < x.position.size(); ++i) {
    for (int c = 0; c < 3; ++c) BOOST_TEST_REQUIRE(x.position[i][c] == y.position[i][c]);
  }
}

}  // namespace walls_in_motion
