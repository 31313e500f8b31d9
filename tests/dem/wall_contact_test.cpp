// Walls through the whole engine: the inside of a cylinder, plates that press.
#include <boost/test/unit_test.hpp>
#include <numbers>

#include "tests/dem/transverse_fibers.hpp"

BOOST_AUTO_TEST_SUITE(wall_contact_test)

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

/// A cylinder about the tilted z axis through the origin, of odd radius.
constexpr double cylinder_radius = 11.3e-3;
dem::Domain in_cylinder() {
  dem::Domain around;
  around.walls = {{dem::Cylinder{tilted(0, 0, 0.017), tilted(0, 0, 1), cylinder_radius}}};
  return around;
}

/// Overlap [m] that presses with `force`.
double pressed(double force, double stiffness) { return std::pow(force / stiffness, 2.0 / 3); }

}  // namespace

BOOST_AUTO_TEST_CASE(a_sphere_circles_in_a_cylinder_as_centripetal_force_has_it) {
  const dem::Domain around = in_cylinder();
  const double k = wall_stiffness(ball, around), m = dem::sphere_mass(ball), R = dem::sphere_radius(ball),
               v = 0.83;
  double overlap = 0;
  for (int i = 0; i < 50; ++i) overlap = pressed(m * v * v / (cylinder_radius - R + overlap), k);
  const double path = cylinder_radius - R + overlap, angle = 0.3;
  const double dt = 0.04 * std::sqrt(m / (1.5 * k * std::sqrt(overlap)));
  dem::Assembly assembly({group_of(ball, path * std::cos(angle), path * std::sin(angle),
                                   {{-v * std::sin(angle), v * std::cos(angle)}, 41})},
                         around, {.step = dt});
  double least = infinite, most = 0;
  const int steps = static_cast<int>(4.3 * 2 * std::numbers::pi * path / v / dt);
  for (int n = 0; n < 40; ++n) {
    assembly.march(steps / 40);
    const auto contacts = assembly.contacts();
    BOOST_REQUIRE(contacts.size() == 2u);
    const double force = norm(contacts[1].force) * path / (m * v * v);
    least = std::min(least, force), most = std::max(most, force);
    const ref::PlanarMotion now = motion_of(assembly, 0);
    within(std::hypot(now.velocity[0], now.velocity[1]) / v, 1, 1e-6, "speed");
    within(now.spin, 41, 1e-9, "spin");
  }
  within(least, 1, 2e-4, "least force");
  within(most, 1, 2e-4, "largest force");
  const V at = place_of(assembly, 0);
  const double turned = angle + v * assembly.time() / path;
  within(std::remainder(std::atan2(at[1], at[0]) - turned, 2 * std::numbers::pi), 0, 2e-3, "angle");
  BOOST_TEST(out_of_plane(assembly, 0) < 1e-9 * v);
}

namespace {

/// Period of small swings at the bottom of the cylinder, x being up.
double swing_period(const dem::ContactProperties& rules) {
  dem::Domain around = in_cylinder();
  around.gravity = tilted(-g, 0, 0);
  around.contacts = rules;
  const double k = wall_stiffness(ball, around), m = dem::sphere_mass(ball), R = dem::sphere_radius(ball);
  const double overlap = pressed(m * g, k), path = cylinder_radius - R + overlap, angle = 0.02;
  const double dt = 0.1 * std::sqrt(m / (1.5 * k * std::sqrt(overlap)));
  dem::Assembly assembly({group_of(ball, -path * std::cos(angle), path * std::sin(angle), {})}, around,
                         {.step = dt});
  double before = path * angle, first = 0, last = 0;
  int crossings = 0;
  while (crossings < 5) {
    assembly.march(1);
    const double y = place_of(assembly, 0)[1];
    if ((y > 0) != (before > 0)) {
      last = assembly.time() - dt * y / (y - before);
      if (crossings++ == 0) first = last;
    }
    before = y;
  }
  return (last - first) / 2 / std::sqrt(path / g);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sphere_swings_at_the_bottom_of_a_cylinder) {
  within(swing_period({1, 0}) / (2 * std::numbers::pi), 1, 2e-4, "sliding freely");
  within(swing_period({0.5, 0.9}) / (2 * std::numbers::pi) / std::sqrt(1.4), 1, 1e-3, "rolling");
}

/// A plate comes down on fibers across it (contacts in series) or upright (contacts and bonds in series),
/// slowly: the force is that of the closure, and the plate's work is what the contacts and bonds store.
BOOST_AUTO_TEST_CASE(a_moving_plate_presses_by_hertz_and_its_work_is_stored) {
  for (const bool upright : {false, true}) {
    dem::Fiber fiber = ball;
    fiber.aspect_ratio = upright ? 3 : 1;
    const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
    const double R = dem::sphere_radius(fiber), height = upright ? 8 * R : 2 * R, speed = 2e-3,
                 closure = 6e-5;
    dem::Domain around;
    around.wall_youngs_modulus = 5.1e6;
    around.wall_poisson_ratio = 0.23;
    around.contacts = {0.7, 0.3};
    around.walls = {{dem::Plane{{}, tilted(1, 0, 0)}},
                    {dem::Plane{tilted(height, 0, 0), tilted(-1, 0, 0)}, tilted(-speed, 0, 0)}};
    const dem::ChainState<3> state =
        dem::placed(chain, {tilted(R, 0.1e-3, 0), upright ? tilted(1, 0, 0) : tilted(0, 0, 1)});
    dem::Assembly assembly({{chain, {state}}}, around, {.account_energy = true});
    const int steps = static_cast<int>(closure / speed / assembly.step());
    assembly.march(steps);
    const double closed = speed * assembly.time();
    // a line of contacts (F/k)^(2/3) and bonds F/K in series
    const double k = wall_stiffness(fiber, around),
                 bonds = upright ? 3 / dem::bond_stiffness(fiber).stretch : 0;
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (2 * pressed(middle, k) + bonds * middle < closed ? low : high) = middle;
    }
    for (const dem::ContactState& c : assembly.contacts()) {
      within(std::abs(untilted(c.force)[0]) / low, 1, 2e-3, "force");
      within(c.overlap / pressed(low, k), 1, 2e-3, "overlap");
    }
    BOOST_TEST(assembly.contacts().size() == (upright ? 2u : 4u));
    const int lines = upright ? 1 : 2;
    const double stored = lines * (2 * 0.4 * low * pressed(low, k) + 0.5 * bonds * low * low);
    const dem::EnergyBalance e = assembly.energy();
    within(e.wall_work / stored, 1, 3e-3, "work");
    within((e.contacts + e.bonds) / stored, 1, 3e-3, "stored");
    if (upright) within(e.bonds / (0.5 * bonds * low * low), 1, 5e-3, "in the bonds");
    within(total(e) / e.wall_work, 0, 1e-3, "balance");
    BOOST_TEST(e.kinetic < 1e-3 * stored);
    BOOST_TEST(e.contact_normal > 0);
    BOOST_TEST(e.contact_normal < 0.01 * stored);
  }
}

BOOST_AUTO_TEST_SUITE_END()
