// Spheres and fibers on planes, through the whole engine: rolling, sliding, rolling friction, rest; against
// closed forms.
#include <boost/test/unit_test.hpp>

#include "reference/friction.hpp"
#include "tests/dem/transverse_fibers.hpp"

BOOST_AUTO_TEST_SUITE(slope_contact_test)

using namespace transverse;

namespace {

constexpr double g = 9.81;
const dem::Fiber ball = fiber_of(2.6e6, 0.31, 1130, 1.66e-3);

void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

/// x is up, y down the slope.
dem::Domain slope(double angle, const dem::ContactProperties& rules) {
  dem::Domain around;
  around.wall_youngs_modulus = 5.1e6;
  around.wall_poisson_ratio = 0.23;
  around.gravity = tilted(-g * std::cos(angle), g * std::sin(angle), 0);
  around.contacts = rules;
  around.walls = {{dem::Plane{{}, tilted(1, 0, 0)}}};
  return around;
}

/// Overlap [m] under the force, and the step that a contact pressed so allows, by a twentieth.
double resting_overlap(const dem::Fiber& fiber, const dem::Domain& around, double force) {
  return std::pow(force / ref::hertz_stiffness(ref::hertz_pair(body_of(fiber), wall_of(around))), 2.0 / 3);
}

/// Acceleration of the center and of R spin over the second half of `time`, starting at `speed` and rolling.
struct Run {
  double acceleration, surface, moved, creep, astray;  ///< creep: speed over the second half
};
Run on_slope(double angle, const dem::ContactProperties& rules, double time, double speed = 0) {
  const dem::Domain around = slope(angle, rules);
  const double R = dem::sphere_radius(ball), m = dem::sphere_mass(ball);
  const double rest = resting_overlap(ball, around, m * g * std::cos(angle));
  const double k =
      1.5 * ref::hertz_stiffness(ref::hertz_pair(body_of(ball), wall_of(around))) * std::sqrt(rest);
  const double dt = 0.08 * std::sqrt(m / k);
  // it turns about -z as it goes along y with x up
  dem::Assembly assembly({group_of(ball, R - rest, 0, {{0, speed}, speed / R})}, around, {.step = dt});
  const int half = static_cast<int>(time / dt / 2);
  assembly.march(half);
  const ref::PlanarMotion middle = motion_of(assembly, 0);
  const double at = place_of(assembly, 0)[1];
  assembly.march(half);
  const ref::PlanarMotion end = motion_of(assembly, 0);
  return {(end.velocity[1] - middle.velocity[1]) / (half * dt), R * (end.spin - middle.spin) / (half * dt),
          place_of(assembly, 0)[1], (place_of(assembly, 0)[1] - at) / (half * dt) / (g * dt),
          out_of_plane(assembly, 0)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sphere_rolls_or_slides_down_a_slope) {
  const double mu = 0.17, limit = std::atan(3.5 * mu);
  for (const double angle : {0.1 * limit, 0.9 * limit, 1.1 * limit, 1.3}) {
    const auto exact = ref::sphere_on_slope(angle, mu, g);
    const Run run = on_slope(angle, {0.4, mu}, 0.03);
    BOOST_TEST(exact.slides == (angle > limit));
    within(run.acceleration / exact.acceleration, 1, 1e-3, "acceleration");
    within(std::abs(run.surface) / exact.surface_acceleration, 1, 1e-3, "spin");
    BOOST_TEST(run.astray < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(rolling_friction_slows_a_rolling_sphere_and_holds_it_on_a_slope) {
  const double mu_r = 0.013;
  for (const double speed : {0.3, -0.3}) {
    const Run slowing = on_slope(0, {0.4, 0.4, mu_r}, 0.06, speed);
    within(-slowing.acceleration / std::copysign(ref::rolling_deceleration(mu_r, g), speed), 1, 2e-3,
           "deceleration");
    BOOST_TEST(std::abs(slowing.moved) > 0.01);
  }
  // down a slope: 5/7 g (sin - mu_r cos); held where tan < mu_r
  const double angle = 0.05;
  const Run down = on_slope(angle, {0.4, 0.4, mu_r}, 0.05);
  within(down.acceleration / (5.0 / 7 * g * (std::sin(angle) - mu_r * std::cos(angle))), 1, 2e-3, "down");
  const Run held = on_slope(0.6 * mu_r, {0.4, 0.4, mu_r}, 0.3);
  within(held.acceleration / g, 0, 1e-9, "held");
  // the moment m g R sin that holds it takes the spin that J / dt makes such a moment of: it creeps by 5/2 g
  // sin dt
  BOOST_TEST_MESSAGE("held by rolling friction it creeps at " << held.creep << " g dt, "
                                                              << held.moved / ball.diameter << " d");
  within(held.creep / std::sin(0.6 * mu_r), 2.5, 0.01, "creep");
  const Run not_held = on_slope(1.2 * mu_r, {0.4, 0.4, mu_r}, 0.3);
  BOOST_TEST(not_held.moved > 20 * std::abs(held.moved));
}

/// A fiber down the slope cannot roll: below Coulomb's limit it stays, its foot springs bent; above it
/// slides.
BOOST_AUTO_TEST_CASE(a_fiber_down_a_slope_rests_without_creep_or_slides) {
  dem::Fiber fiber = ball;
  fiber.aspect_ratio = 5;
  fiber.bond_damping = 0.4;
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double mu = 0.37, R = dem::sphere_radius(fiber), m = dem::sphere_mass(fiber);
  for (const double part : {0.6, 0.95, 1.3}) {
    const double angle = std::atan(part * mu);
    const dem::Domain around = slope(angle, {0.3, mu});
    const double rest = resting_overlap(fiber, around, m * g * std::cos(angle));
    dem::Assembly assembly({{chain, {dem::placed(chain, {tilted(R - rest, 0, 0), tilted(0, 1, 0)})}}}, around,
                           {});
    const auto steps = [&](double t) { return static_cast<int>(t / assembly.step()); };
    const auto foot = [&] { return untilted(assembly.state(0, 0).poses[0].position); };
    assembly.march(steps(0.15));
    const V before = foot();
    const V velocity = untilted(assembly.state(0, 0).velocity[2]);
    assembly.march(steps(0.15));
    const V after = foot();
    V force{};
    for (const dem::ContactState& c : assembly.contacts()) {
      const V f = untilted(c.force);
      force = force + f;
      BOOST_TEST(std::abs(f[1]) < mu * f[0] * (1 + 1e-9));
    }
    within(force[0] / (6 * m * g), std::cos(angle), 2e-4, "carried");
    if (part < 1) {
      within(after[1] / fiber.diameter, before[1] / fiber.diameter, 1e-10, "creep");
      within(force[1] / (6 * m * g), -std::sin(angle), 1e-6, "held");
      BOOST_TEST(after[1] < 0.01 * fiber.diameter);
    } else {
      const double t = steps(0.15) * assembly.step(), a = g * (std::sin(angle) - mu * std::cos(angle));
      within((untilted(assembly.state(0, 0).velocity[2])[1] - velocity[1]) / (a * t), 1, 2e-3, "slides");
    }
  }
}

/// What a contact remembers stays when the neighbor list is updated, here at nearly every step for a fiber
/// that flies by.
BOOST_AUTO_TEST_CASE(a_fiber_held_by_friction_does_not_notice_that_pairs_are_listed_anew) {
  dem::Fiber fiber = ball;
  fiber.aspect_ratio = 3;
  fiber.bond_damping = 0.4;
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double R = dem::sphere_radius(fiber);
  const dem::Domain around = slope(0.3, {0.3, 0.5, 0.05});
  const auto held = dem::placed(chain, {tilted(0.99 * R, 0, 0), tilted(0, 1, 0.4)});
  const auto upon = dem::placed(chain, {tilted(2.9 * R, 0.4 * R, -1e-3), tilted(0.02, 0.1, 1)});
  const auto flies = dem::placed(chain, {tilted(0.1, 0, 0), tilted(0, 1, 0), tilted(3, 40, -30)});
  const auto leaves = dem::placed(chain, {tilted(0.1, 0, 0), tilted(0, 1, 0)});
  std::vector<V> positions[2];
  for (const bool fast : {false, true}) {
    dem::Assembly assembly({{chain, {held, upon, fast ? flies : leaves}}}, around, {.step = 4e-6});
    assembly.march(6000);
    BOOST_TEST(assembly.touching() >= 4);
    double tangential = 0;
    for (const auto& c : assembly.contacts())
      tangential += is_facet(c.key.second) ? std::abs(untilted(c.force)[1]) : 0;
    BOOST_TEST(tangential > 1e-6);
    for (int f : {0, 1}) {
      for (const auto& pose : assembly.state(0, f).poses) positions[fast].push_back(pose.position);
    }
  }
  for (std::size_t i = 0; i < positions[0].size(); ++i)
    BOOST_TEST(norm(positions[1][i] - positions[0][i]) < 1e-11 * R);
}

BOOST_AUTO_TEST_SUITE_END()
