// Walls that come and go and move along, through the whole engine.
#include <boost/test/unit_test.hpp>

#include "dem/contact/restitution.hpp"
#include "tests/dem/small_packing.hpp"
#include "tests/dem/transverse_fibers.hpp"

BOOST_AUTO_TEST_SUITE(moving_wall_test)

using namespace transverse;

namespace {

constexpr double g = 9.81;
const dem::Fiber ball = fiber_of(2.6e6, 0.31, 1130, 1.66e-3);

void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

double wall_stiffness(const dem::Fiber& fiber, const dem::Domain& around) {
  return ref::hertz_stiffness(ref::hertz_pair(body_of(fiber), wall_of(around)));
}

/// How high a sphere rises that fell so far, its weight on it while it touches: m x'' = F - m g with Hertz's
/// spring and a dashpot, as long as they push, by Runge and Kutta's method in steps of a tenth of a
/// microsecond.
double rise_after(double fall, double restitution, const dem::Fiber& fiber, const dem::Domain& around) {
  const double k = wall_stiffness(fiber, around), m = dem::sphere_mass(fiber),
               zeta = dem::damping_ratio_for(restitution);
  const double c = 2 * zeta * std::sqrt(1.25 * m * k), h = 1e-7;
  const auto pull = [&](double d, double v) {  // overlap and its rate
    return g - (d > 0 ? k * std::pow(d, 1.5) + c * std::pow(d, 0.25) * v : 0) / m;
  };
  double d = 0, v = std::sqrt(2 * g * fall);
  while (d >= 0 && (v > 0 || pull(d, v) < g)) {
    const double a1 = pull(d, v), v2 = v + h / 2 * a1, a2 = pull(d + h / 2 * v, v2), v3 = v + h / 2 * a2,
                 a3 = pull(d + h / 2 * v2, v3), v4 = v + h * a3, a4 = pull(d + h * v3, v4);
    d += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return v * v / (2 * g) - d;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_wall_that_opens_lets_fall_and_one_that_appears_catches) {
  dem::Fiber fiber = ball;
  fiber.aspect_ratio = 4;
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double R = dem::sphere_radius(fiber), m = dem::sphere_mass(fiber), opens = 0.0102, floor = -3.1e-3,
               e = 0.4;
  dem::Domain around;
  around.gravity = tilted(-g, 0, 0);
  around.contacts = {e, 0.3};
  const dem::Plane up{{}, tilted(1, 0, 0)};
  around.walls = {{up, {}, 0, opens},  // opens
                  {up, {}, 1.0},       // would be in the way much later
                  {dem::Plane{tilted(floor, 0, 0), tilted(1, 0, 0)}, {}, opens + 0.0143}};  // appears below
  const double rest = std::pow(m * g / wall_stiffness(fiber, around), 2.0 / 3);
  dem::Assembly assembly({{chain, {dem::placed(chain, {tilted(R - rest, 0, 0), tilted(0, 0.6, 0.8)})}}},
                         around, {.step = 1e-6});
  const double dt = assembly.step();
  assembly.march(static_cast<int>(opens / dt) - 1);
  BOOST_TEST(assembly.touching() == 5);
  within(place_of(assembly, 0, 3)[0] / (R - rest), 1, 1e-9, "rests");
  assembly.march(3);
  BOOST_TEST(assembly.touching() == 0);
  const V x = place_of(assembly, 0, 1);
  const double v = motion_of(assembly, 0, 1).velocity[0], t0 = assembly.time();
  // to shortly before it lands: 1e-3 m above
  const double fall = x[0] - (floor + R), until = std::sqrt(2 * (fall - 2e-4) / g);
  for (const double part : {0.4, 0.6}) {
    assembly.march(static_cast<int>(part * until / dt) - 2);
    const double t = assembly.time() - t0;
    within(place_of(assembly, 0, 1)[0], x[0] + v * t - 0.5 * g * t * t, 1e-13, "falls");
    within(motion_of(assembly, 0, 1).velocity[0], v - g * t, 1e-11, "speed");
    BOOST_TEST(assembly.touching() == 0);
  }
  // all spheres land at once, as each alone: the highest it rises to again is e^2 of the fall
  double highest = -1, now = 0, before = -1;
  while (assembly.touching() == 0) assembly.march(1);
  while (assembly.touching() > 0) assembly.march(1);
  do {
    before = now;
    assembly.march(10);
    now = place_of(assembly, 0, 1)[0] - floor - R;
    highest = std::max(highest, now);
  } while (now > before);
  within(highest / rise_after(fall, e, fiber, around), 1, 2e-3, "rises again");
  BOOST_TEST(std::abs(highest / fall - e * e) < 0.05 * e * e);  // its weight adds to the contact, a little
}

/// A plate presses fibers and hands over to one at rest, which is how a plate stops: nothing is gained by it.
BOOST_AUTO_TEST_CASE(a_plate_that_stops_gives_nothing) {
  dem::Fiber fiber = ball;
  fiber.aspect_ratio = 5;
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double R = dem::sphere_radius(fiber), speed = 0.3, stops = 2.1e-3;
  const double steps[] = {2e-6, 1e-6};
  double jump[2], pressed = 0;
  for (int n = 0; n < 2; ++n) {
    dem::Domain around;
    around.contacts = {0.4, 0.3};
    const double high = 4 * R;
    around.walls = {{dem::Plane{{}, tilted(1, 0, 0)}},
                    {dem::Plane{tilted(high, 0, 0), tilted(-1, 0, 0)}, -speed * tilted(1, 0, 0), 0, stops},
                    {dem::Plane{tilted(high - speed * stops, 0, 0), tilted(-1, 0, 0)}, {}, stops}};
    dem::FiberGroup group{chain, {}};
    for (const double x : {R, 3 * R})
      group.fibers.push_back(dem::placed(chain, {tilted(x, 0, 0), tilted(0, 0.6, 0.8)}));
    dem::Assembly assembly({group}, around, {.step = steps[n], .account_energy = true});
    assembly.march(static_cast<int>(stops / steps[n]) - 1);
    const dem::EnergyBalance before = assembly.energy();
    BOOST_TEST(assembly.touching() == 18);
    assembly.march(4);
    const dem::EnergyBalance after = assembly.energy();
    pressed = before.contacts;
    jump[n] = (total(after) - total(before)) / before.contacts;
    BOOST_TEST_MESSAGE("a plate that stops at " << steps[n] << " s a step: total off by " << jump[n]
                                                << " of what contacts hold");
    BOOST_TEST(std::abs(before.wall_work / before.contacts) > 1);
  }
  BOOST_TEST(pressed > 0);
  BOOST_TEST(std::abs(jump[0]) < 1e-3);
  BOOST_TEST(std::abs(jump[1]) < 0.6 * std::abs(jump[0]));
}

/// The same scene with everything moving along at one velocity is the same scene.
BOOST_AUTO_TEST_CASE(walls_that_move_along_change_nothing) {
  std::vector<V> positions[2];
  for (const bool moving : {false, true}) {
    const V u = moving ? V{0.31, -0.22, 0.17} : V{};
    dem::Fiber fiber = ball;
    fiber.aspect_ratio = 3;
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
    dem::Domain around;
    around.walls = {{dem::Cylinder{tilted(0, 0, 0.017), tilted(0, 0, 1), 11.3e-3}}};
    around.walls.push_back({dem::Plane{tilted(-5e-3, 0, 0), tilted(1, 0, 0)}});
    around.walls.push_back({dem::Plane{tilted(0, 0, -4e-3), tilted(0, 0, 1)}});
    for (dem::Wall& wall : around.walls) wall.velocity = u;
    around.contacts = {0.6, 0.4, 0.03};
    around.gravity = tilted(-g, 1.3, -2.1);
    dem::FiberGroup group{chain, {}};
    for (int f = 0; f < 5; ++f) {
      group.fibers.push_back(dem::placed(chain, {tilted(-2e-3 + 2.1e-3 * f, -3e-3 + 1e-3 * f, 0),
                                                 tilted(0.1 * f, 1, 0.2 * f), u + tilted(-0.5, 0.4, -0.3)}));
    }
    dem::Assembly assembly({group}, around, {.step = 3e-6});
    std::int64_t most = 0;
    for (int n = 0; n < 50; ++n) {
      assembly.march(60);
      most = std::max(most, assembly.touching());
    }
    BOOST_TEST(most > 3);
    for (int f = 0; f < 5; ++f) {
      for (const auto& pose : assembly.state(0, f).poses)
        positions[moving].push_back(pose.position - assembly.time() * u);
    }
  }
  for (std::size_t i = 0; i < positions[0].size(); ++i)
    BOOST_TEST(norm(positions[1][i] - positions[0][i]) < 1e-9 * ball.diameter);
}

/// The same scene turned as a whole is the same scene.
BOOST_AUTO_TEST_CASE(a_packing_turned_as_a_whole_does_the_same) {
  const scenes::SmallPacking packing = scenes::packing_in_a_box(14, 9);
  scenes::SmallPacking turned = packing;
  turned.around.gravity = rotate(tilt, packing.around.gravity);
  for (dem::Wall& wall : turned.around.walls) {
    auto& plane = *wall.shape.get_if<dem::Plane>();
    plane = {rotate(tilt, plane.point), rotate(tilt, plane.normal)};
  }
  for (auto& group : turned.groups) {
    for (auto& fiber : group.fibers) {
      for (std::size_t i = 0; i < fiber.poses.size(); ++i) {
        fiber.poses[i] = {rotate(tilt, fiber.poses[i].position), tilt * fiber.poses[i].orientation};
        fiber.velocity[i] = rotate(tilt, fiber.velocity[i]);
      }
    }
  }
  for (const auto form : {dem::BondForm::incremental, dem::BondForm::total}) {
    dem::Assembly one = packing.assembly({.form = form}), other = turned.assembly({.form = form});
    std::int64_t most = 0;
    for (int n = 0; n < 8; ++n) {
      one.march(50);
      other.march(50);
      most = std::max(most, one.touching());
    }
    BOOST_TEST(most > 3);
    const auto x = one.placed().position, y = other.placed().position;
    double off = 0;
    for (std::size_t i = 0; i < x.size(); ++i) off = std::max(off, norm(rotate(tilt, x[i]) - y[i]));
    BOOST_TEST(off < 1e-9 * 2e-3, off);
  }
}

BOOST_AUTO_TEST_SUITE_END()
