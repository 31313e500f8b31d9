// Walls that turn, swing and are driven, and what fibers do to them, through the whole engine.
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

BOOST_AUTO_TEST_SUITE(wall_motion_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;
using namespace walls_in_motion;

namespace {

dem::FiberGroup alone(const dem::Fiber& fiber, const V& first, const V& along, const V& velocity = {}) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  return {chain, {dem::placed(chain, {first, along, velocity})}};
}

double mass_of(const dem::Fiber& fiber) { return dem::fiber_mass(fiber); }

V middle(const dem::Assembly& assembly) {
  V sum{};
  const auto state = assembly.state(0, 0);
  for (const auto& pose : state.poses)
    sum = sum + (1.0 / static_cast<double>(state.poses.size())) * pose.position;
  return sum;
}

}  // namespace

namespace {

struct Angle {
  double mean, depth;  ///< from the bottom [rad], of the middle's sphere in the wall [m]
};

/// Where a fiber's middle is in a drum about y through `center`, over so many steps. Coulomb's friction takes
/// nothing from its swings about the place of rest: they are averaged out by a window without ends (Hann).
Angle angle_in_drum(dem::Assembly& assembly, const V& center, double drum, int samples) {
  Angle sum{};
  const double R = dem::sphere_radius(assembly.chain(0).fiber);
  for (int n = 0; n < samples; ++n) {
    assembly.march(500);
    V at = middle(assembly) - center;
    at[1] = 0;
    const double weight = (1 - std::cos(2 * pi * (n + 0.5) / samples)) / samples;
    sum.mean += weight * std::atan2(at[0], -at[2]);
    sum.depth += weight * (R - (drum - norm(at)));
  }
  return sum;
}

}  // namespace

namespace {

/// Error of the total energy over the walls' work with three steps, each half of the one before: a fiber
/// stays on a drum that swings about its axis, to and fro and up and down, without impacts.
std::array<double, 3> errors_on_a_swinging_drum(double friction) {
  std::array<double, 3> off{};
  for (int n = 0; n < 3; ++n) {
    const dem::Fiber fiber = fiber_with(4);
    const double R = dem::sphere_radius(fiber), drum = 0.0231, T = 0.048;
    dem::Domain around;
    around.gravity = {0, 0, -g};
    around.contacts = {.restitution = 0.8, .friction = friction};
    dem::Wall wall{dem::Cylinder{{}, {0, 1, 0}, drum}};
    wall.motion.about = dem::WallAxis{{}, {0, 1, 0}};
    wall.motion.course = dem::WallCourse{
        {1, 0, 0}, dem::monotone_cubic({0, T}, {0, 2e-3}), dem::monotone_cubic({0, T}, {0, 0.3})};
    wall.motion.oscillation = dem::WallOscillation{{0, 0, 1}, 5e-5, 60, 0.5 * pi};
    around.walls = {wall};
    const double E = 2.6e6 / (1 - 0.17 * 0.17), k = 4.0 / 3 * E * std::sqrt(R),
                 rest = std::pow(dem::sphere_mass(fiber) * g / k, 2.0 / 3), step = 1.6e-5 / (1 << n);
    dem::Assembly assembly({alone(fiber, {0, 0, -(drum - R + 1.5 * rest)}, {0, 1, 0})}, around,
                           {.step = step, .account_energy = true});
    const double begin = total(assembly.energy());
    assembly.march(static_cast<std::int64_t>(std::round(T / step)));
    BOOST_TEST(assembly.touching() == 5);
    const dem::EnergyBalance now = assembly.energy();
    off[n] = (total(now) - begin) / std::abs(now.wall_work);
    BOOST_TEST_MESSAGE("swinging drum at " << step << " s: off by " << off[n] << " of the work");
  }
  return off;
}

}  // namespace

BOOST_AUTO_TEST_CASE(work_of_a_swinging_drum_is_of_second_order) {
  const std::array<double, 3> smooth = errors_on_a_swinging_drum(0), rough = errors_on_a_swinging_drum(0.9);
  BOOST_TEST(std::abs(smooth[0]) < 3e-5);
  for (int n = 0; n < 2; ++n) within(smooth[n] / smooth[n + 1], 4, 0.6, "order 2");
  // with friction some of the first order is left, as small
  BOOST_TEST(std::abs(rough[0]) < 6e-6);
  for (int n = 0; n < 2; ++n) BOOST_TEST(rough[n] / rough[n + 1] > 2.5);
}

/// In a turning drum a fiber that rolls comes to rest where mu_r R F_n holds its weight's moment:
/// m g sin(theta) arm = mu_r R m g cos(theta).
BOOST_AUTO_TEST_CASE(what_rolls_in_a_drum_rests_at_the_angle_of_rolling_friction) {
  const dem::Fiber fiber = fiber_with(4);
  const double R = dem::sphere_radius(fiber), drum = 0.0231, mu_r = 0.21;
  dem::Domain around;
  around.gravity = {0, 0, -g};
  around.contacts = {.restitution = 0.1, .friction = 0.9, .rolling_friction = mu_r};
  dem::Wall wall{dem::Cylinder{{0, 0, 0.01}, {0, 1, 0}, drum}};
  wall.motion.about = dem::WallAxis{{0, 0.3, 0.01}, {0, 1, 0}};
  wall.motion.angular_velocity = -2.3;  // its bottom goes along +x
  around.walls = {wall};
  dem::Assembly assembly({alone(fiber, {0.2 * drum, 0, 0.01 - 0.97 * (drum - R)}, {0, 1, 0})}, around,
                         {.step = 5e-6});
  assembly.march(200000);
  const auto [angle, depth] = angle_in_drum(assembly, {0, 0, 0.01}, drum, 800);
  const double expected = std::atan(mu_r * R / (R - depth));
  BOOST_TEST_MESSAGE("drum: " << angle << " rad, statics " << expected);
  within(angle / expected, 1, 2e-3, "angle");
}

/// A fiber across the drum's axis cannot roll: it slides where both ends' friction holds it. Statics of a
/// chord: N1, N2 along the radii, mu N1, mu N2 across them, the weight; the moment about the drum's axis is
/// mu (N1 + N2) radius = m g d sin(theta).
BOOST_AUTO_TEST_CASE(what_cannot_roll_in_a_drum_rests_at_the_angle_of_friction) {
  dem::Fiber fiber = fiber_with(1, 2.6e7);
  const double R = dem::sphere_radius(fiber), drum = 0.0231, mu = 0.43;
  dem::Domain around;
  around.gravity = {0, 0, -g};
  around.contacts = {.restitution = 0.1, .friction = mu};
  dem::Wall wall{dem::Cylinder{{}, {0, 1, 0}, drum}};
  wall.motion.about = dem::WallAxis{{}, {0, 1, 0}};
  wall.motion.angular_velocity = -2.3;
  around.walls = {wall};
  const double path = drum - R, half = R, alpha = std::asin(half / path), d = path * std::cos(alpha);
  const double start = 0.38;
  const V along{std::cos(start), 0, std::sin(start)}, out{std::sin(start), 0, -std::cos(start)};
  dem::Assembly assembly({alone(fiber, d * out - half * along, along)}, around, {.step = 2e-6});
  assembly.march(200000);
  const double angle = angle_in_drum(assembly, {}, drum, 1600).mean;
  // unknown N1, N2 of a weight 1 at angle theta; residual: the moment
  const auto residual = [&](double theta) {
    const double a = theta - alpha, b = theta + alpha;
    // along x and z: N (-sin, cos) + mu N (cos, sin) at angle a from the bottom
    const double ax = -std::sin(a) + mu * std::cos(a), az = std::cos(a) + mu * std::sin(a),
                 bx = -std::sin(b) + mu * std::cos(b), bz = std::cos(b) + mu * std::sin(b);
    const double det = ax * bz - bx * az, N1 = -bx / det, N2 = ax / det;
    return mu * (N1 + N2) * drum - d * std::sin(theta);
  };
  double low = 0, high = 1.2;
  for (int n = 0; n < 60; ++n) (residual(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  BOOST_TEST_MESSAGE("drum: " << angle << " rad, statics " << low << ", atan mu " << std::atan(mu));
  within(angle / low, 1, 2e-3, "angle");
}

namespace {

/// Times of the first impacts of a body that falls on a plate z = A (sin(w t + phase) - sin phase),
/// restitution e.
std::vector<double> impacts(double height, double A, double f, double phase, double e, int count) {
  const double w = 2 * pi * f;
  double t0 = 0, z0 = height, v0 = 0;
  std::vector<double> all;
  while (static_cast<int>(all.size()) < count) {
    const auto gap = [&](double t) {
      const double s = t - t0;
      return z0 + v0 * s - 0.5 * g * s * s - A * (std::sin(w * t + phase) - std::sin(phase));
    };
    double a = t0 + 1e-6, h = 1e-5;
    while (gap(a + h) > 0) a += h;
    double b = a + h;
    for (int n = 0; n < 60; ++n) (gap(0.5 * (a + b)) > 0 ? a : b) = 0.5 * (a + b);
    const double plate = A * w * std::cos(w * b + phase), v = v0 - g * (b - t0);
    z0 = z0 + v0 * (b - t0) - 0.5 * g * (b - t0) * (b - t0);
    v0 = plate - e * (v - plate), t0 = b;
    all.push_back(b);
  }
  return all;
}

/// Middles of the first contacts with the plate.
std::vector<double> contacts_of(double youngs_modulus, double height, const dem::WallOscillation& swing,
                                double e, int count) {
  const dem::Fiber fiber = fiber_with(1, youngs_modulus);
  dem::Domain around;
  around.gravity = {0, 0, -g};
  around.contacts = {.restitution = e, .friction = 0.2};
  dem::Wall plate{dem::Plane{{}, {0, 0, 1}}};
  plate.motion.oscillation = swing;
  around.walls = {plate};
  const double R = dem::sphere_radius(fiber), dt = 4e-6 * std::sqrt(1e6 / youngs_modulus);
  dem::Assembly assembly({alone(fiber, {0, 0, R + height}, {1, 0, 0})}, around, {.step = dt});
  std::vector<double> all;
  while (static_cast<int>(all.size()) < count) {
    while (assembly.touching() == 0) assembly.march(1);
    const double begin = assembly.time();
    while (assembly.touching() > 0) assembly.march(1);
    all.push_back(0.5 * (begin + assembly.time()));
  }
  return all;
}

}  // namespace

/// A shaker: the soft sphere's impacts come to those of a hard one as it gets harder, in proportion to how
/// long they last, E^(-2/5).
BOOST_AUTO_TEST_CASE(a_bouncing_fiber_on_a_shaker_follows_its_events) {
  const dem::WallOscillation swing{.axis = {0, 0, 1}, .amplitude = 6e-4, .frequency = 23, .phase = 0.7};
  const double height = 4.1e-3, e = 0.6;
  const int count = 4;
  const std::vector<double> hard = impacts(height, swing.amplitude, swing.frequency, swing.phase, e, count);
  double off[2][4];
  for (int n = 0; n < 2; ++n) {
    const std::vector<double> soft = contacts_of(n == 0 ? 1e6 : 32e6, height, swing, e, count);
    for (int i = 0; i < count; ++i) off[n][i] = soft[i] - hard[i];
  }
  for (int i = 0; i < count; ++i) {
    BOOST_TEST_MESSAGE("impact " << i << " at " << hard[i] << " s, off by " << off[0][i] << ", "
                                 << off[1][i]);
    BOOST_TEST(std::abs(off[1][i]) < 0.01 * hard[i]);
    BOOST_TEST(std::abs(off[1][i]) < 0.5 * std::abs(off[0][i]));  // 32^(-2/5) = 0.25
  }
}

/// A driven plate on a fiber comes to rest where it carries the force, and the floor the weight too.
BOOST_AUTO_TEST_CASE(a_driven_plate_rests_at_the_force_it_carries) {
  const dem::Fiber fiber = fiber_with(3);
  const double R = dem::sphere_radius(fiber), force = 0.0137, W = mass_of(fiber) * g;
  dem::Domain around;
  around.gravity = {0, 0, -g};
  around.contacts = {.restitution = 0.3, .friction = 0.4};
  dem::Wall lid{dem::Plane{{0, 0, 2.2 * R}, {0, 0, -1}}};
  lid.motion.drive = dem::WallDrive{.axis = {0, 0, -1}, .mass = 3e-4, .force = force, .damping = 0.1};
  around.walls = {{dem::Plane{{}, {0, 0, 1}}}, lid};
  dem::Assembly assembly({alone(fiber, {0, 0, R}, {1, 0, 0})}, around, {.step = 4e-6});
  assembly.march(250000);
  assembly.begin_wall_interval();
  assembly.march(1000);
  const auto samples = assembly.wall_samples();
  within(samples[1].mean.force[2] / force, 1, 1e-6, "on the plate");
  within(samples[0].mean.force[2] / -(force + W), 1, 1e-6, "on the floor");
  // Hertz: four spheres share it
  const double E = 2.6e6 / (1 - 0.17 * 0.17), k = 4.0 / 3 * E * std::sqrt(R);
  const double top = std::pow(force / 4 / k, 2.0 / 3), bottom = std::pow((force + W) / 4 / k, 2.0 / 3);
  within((2 * R - samples[1].center[2]) / (top + bottom), 1, 2e-3, "height of the plate");
}

BOOST_AUTO_TEST_SUITE_END()
