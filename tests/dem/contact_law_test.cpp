// The contact law in a leapfrog against references without a time step: Hertz's closed forms, restitution,
// oblique impact integrated by CVODE, friction and rolling on planes; what it must keep in any frame and in
// any lane.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <xsimd/xsimd.hpp>

#include "dem/model/errors.hpp"
#include "reference/friction.hpp"
#include "reference/two_spheres.hpp"
#include "tests/dem/colliding_spheres.hpp"

BOOST_AUTO_TEST_SUITE(contact_law_test)

namespace ref = fiberchain::reference;
using namespace colliding;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr ref::ElasticBody ball{0.83e-3, 2.4e-6, 2.6e8, 0.31}, other{1.37e-3, 1.9e-5, 7.1e7, 0.22},
    wall{infinite, infinite, 3.3e9, 0.41};

/// A frame that no axis of the computation agrees with.
const dem::Quaternion<double> tilt = dem::rotation({0.7, -1.9, 0.4});
V tilted(double x, double y, double z) { return rotate(tilt, V{x, y, z}); }

struct Outcome {
  double time, overlap;
  ref::PlanarMotion first, second;
  double out_of_plane;  ///< velocity over the closing speed
};

ref::PlanarMotion planar(const Sphere& s) {
  const V v = rotate(conjugate(tilt), s.velocity);
  return {{v[0], v[1]}, rotate(conjugate(tilt), s.spin)[2]};
}

Sphere sphere_of(const ref::ElasticBody& body, const ref::PlanarMotion& m) {
  return {body.radius, body.mass, {}, tilted(m.velocity[0], m.velocity[1], 0), tilted(0, 0, m.spin)};
}

/// `steps` a collision; the touch falls somewhere within a step.
Outcome collide(const ref::ElasticBody& first, const ref::ElasticBody& second, const ref::ContactLaw& law,
                const ref::PlanarMotion& one, const ref::PlanarMotion& two, double steps,
                double extrapolation = 0.5) {
  const ref::HertzPair pair = ref::hertz_pair(first, second);
  const double closing = one.velocity[0] - two.velocity[0];
  const double dt = ref::hertz_collision(pair, closing).time / steps;
  Sphere a = sphere_of(first, one);
  PairStep p{parameters({pair.modulus, pair.shear_modulus, law.damping_ratio, law.friction}, pair.radius,
                        pair.mass, a.inertia(), dt),
             dt};
  p.parameters.extrapolation = extrapolation;
  Record record;
  const double gap = 0.37 * dt * closing;
  if (std::isinf(second.radius)) {
    const V up = tilted(-1, 0, 0);
    a.position = (a.radius + gap) * up;
    while (!record.over) step(p, a, up, {}, record);
    return {record.pushing * dt,
            record.overlap,
            planar(a),
            {},
            std::abs(rotate(conjugate(tilt), a.velocity)[2]) / closing};
  }
  Sphere b = sphere_of(second, two);
  b.position = tilted(a.radius + b.radius, 0, 0) - 0.37 * dt * (b.velocity - a.velocity);
  while (!record.over) step(p, a, b, record);
  return {record.pushing * dt, record.overlap, planar(a), planar(b),
          std::abs(rotate(conjugate(tilt), a.velocity)[2]) / closing};
}

void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

}  // namespace

BOOST_AUTO_TEST_CASE(head_on_collisions_are_hertz_to_a_thousandth) {
  for (const double e : {1.0, 0.83, 0.5, 0.4, 0.17}) {
    const double zeta = dem::damping_ratio_for(e);
    for (const auto& second : {other, wall}) {
      for (const double speed : {0.013, 0.9}) {
        const auto closed = ref::damped_hertz_collision(ref::hertz_pair(ball, second), zeta, speed);
        const auto hit = collide(ball, second, {zeta, 0.6}, {{speed, 0}, 0}, {}, 1000);
        within(hit.time / closed.time, 1, 1.5e-3, "time");  // a step is a thousandth
        within(hit.overlap / closed.overlap, 1, 1e-4, "overlap");
        within((hit.second.velocity[0] - hit.first.velocity[0]) / (e * speed), 1, 1e-4, "restitution");
        within(closed.restitution, e, 1e-12, "reference");
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(restitution_converges_with_the_step) {
  const double zeta = dem::damping_ratio_for(0.4);
  const auto off = [&](double steps, double extrapolation) {
    const auto hit = collide(ball, wall, {zeta, 0}, {{0.37, 0}, 0}, {}, steps, extrapolation);
    return std::abs(hit.first.velocity[0] / 0.37 + 0.4) / 0.4;
  };
  for (const double steps : {50, 200, 800}) {
    BOOST_TEST_MESSAGE(steps << " steps a collision: restitution 0.4 off by " << off(steps, 0)
                             << " at the lagged velocity, " << off(steps, 0.5) << " at the extrapolated one");
  }
  const double order = std::log(off(50, 0) / off(3200, 0)) / std::log(64.0);
  BOOST_TEST(order > 0.9);
  BOOST_TEST(order < 1.1);
  BOOST_TEST(off(50, 0.5) < 2e-3);
  BOOST_TEST(off(200, 0.5) < 0.1 * off(200, 0));
}

BOOST_AUTO_TEST_CASE(a_resting_sphere_presses_a_hertzian_overlap) {
  // dropped from the touch and left until the dashpot has brought it to rest
  const ref::HertzPair pair = ref::hertz_pair(ball, wall);
  const double g = 300, rest = std::pow(ball.mass * g / ref::hertz_stiffness(pair), 2.0 / 3);
  const V up = tilted(-1, 0, 0);
  for (const double extrapolation : {0.0, 0.5}) {
    for (const double part : {0.05, 0.3}) {
      const double dt = part * std::sqrt(ball.mass / (1.5 * ref::hertz_stiffness(pair) * std::sqrt(rest)));
      Sphere a = sphere_of(ball, {});
      a.position = (a.radius - 0.3 * rest) * up;
      PairStep p{
          parameters({pair.modulus, pair.shear_modulus, 0.3, 0.4}, pair.radius, pair.mass, a.inertia(), dt),
          dt};
      p.parameters.extrapolation = extrapolation;
      Record record;
      for (int i = 0; i < 4000; ++i) step(p, a, up, (-g) * up, record);
      within((a.radius - dot(a.position, up)) / rest, 1, 1e-9, "overlap");
      BOOST_TEST(norm(a.velocity) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(restitution_is_that_of_the_quadrature) {
  // the closed form is checked by integration in tests/reference; here that the two agree and invert
  for (const double zeta : {0.0, 0.04, 0.28, 0.9999999, 1.0, 1.00001, 2.3}) {
    within(dem::restitution_of(zeta), ref::hertz_restitution(zeta, ref::ContactEnd::zero_force), 1e-8,
           "restitution");
  }
  for (const double e : {1.0, 0.999, 0.472, 0.4, 0.01})
    within(dem::restitution_of(dem::damping_ratio_for(e)), e, 1e-14, "e");
  within(dem::restitution_of(ref::common_damping_ratio(0.4)), 0.472, 5e-4, "the common formula");
  BOOST_CHECK_THROW(dem::damping_ratio_for(0), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::damping_ratio_for(1.01), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::restitution_of(-0.1), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(oblique_impact_sticks_and_slides_as_the_differential_equations_say) {
  double worst = 0;
  int sticks = 0, slides = 0, changes = 0;
  for (const double e : {1.0, 0.4, 0.71}) {
    for (const double mu : {0.07, 0.6}) {
      for (const double across : {-0.03, 0.11, 0.31, 0.9, 2.3}) {
        for (const auto& second : {other, wall}) {
          const ref::ContactLaw law{dem::damping_ratio_for(e), mu};
          const ref::PlanarMotion one{{0.37, across}, 83},
              two = std::isinf(second.radius) ? ref::PlanarMotion{} : ref::PlanarMotion{{-0.21, 0.05}, -29};
          const auto exact = ref::collide(ball, second, law, one, two);
          const auto hit = collide(ball, second, law, one, two, 1000);
          const double speed = one.velocity[0] - two.velocity[0];
          const auto compare = [&](const ref::PlanarMotion& a, const ref::PlanarMotion& b, double radius) {
            for (int k = 0; k < 2; ++k)
              worst = std::max(worst, std::abs(a.velocity[k] - b.velocity[k]) / speed);
            worst = std::max(worst, std::abs(a.spin - b.spin) * radius / speed);
          };
          compare(hit.first, exact.first, ball.radius);
          if (!std::isinf(second.radius)) compare(hit.second, exact.second, other.radius);
          within(hit.overlap / exact.overlap, 1, 1e-3, "overlap");
          BOOST_TEST(hit.out_of_plane < 1e-12);
          exact.starts_sliding ? ++slides : ++sticks;
          changes += exact.changes;
        }
      }
    }
  }
  BOOST_TEST_MESSAGE("oblique impact: velocities and R spin off by "
                     << worst << " of the closing speed; " << sticks << " start sticking, " << slides
                     << " sliding");
  BOOST_TEST(worst < 1e-3);  // the tangential dashpot lags
  BOOST_TEST(worst > 1e-8);
  BOOST_TEST(sticks > 10);
  BOOST_TEST(slides > 10);
  BOOST_TEST(changes > 20);
}

namespace {

/// A sphere on a slope, settled into its overlap; acceleration of center and surface over the second half of
/// `time`.
struct Run {
  double acceleration, surface;
};
Run on_slope(double angle, double friction, double time, double rolling = 0, double start = 0) {
  const ref::HertzPair pair = ref::hertz_pair(ball, wall);
  const double g = 9.81,
               rest = std::pow(ball.mass * g * std::cos(angle) / ref::hertz_stiffness(pair), 2.0 / 3);
  const double dt = 0.05 * std::sqrt(ball.mass / (1.5 * ref::hertz_stiffness(pair) * std::sqrt(rest)));
  Sphere a = sphere_of(ball, {{0, start}, -start / ball.radius});
  const V up = tilted(-1, 0, 0), down = tilted(0, 1, 0);
  const V gravity = (-g * std::cos(angle)) * up + (g * std::sin(angle)) * down;
  a.position = (ball.radius - rest) * up;
  const PairStep p{parameters({pair.modulus, pair.shear_modulus, 0.4, friction, rolling}, pair.radius,
                              pair.mass, a.inertia(), dt),
                   dt};
  Record record;
  const auto steps = static_cast<int>(time / dt);
  double v = 0, w = 0;
  for (int i = 0; i < steps; ++i) {
    if (i == steps / 2) v = dot(a.velocity, down), w = dot(a.spin, tilted(0, 0, 1));
    step(p, a, up, gravity, record);
  }
  const double half = (steps - steps / 2) * dt;
  return {(dot(a.velocity, down) - v) / half, ball.radius * (dot(a.spin, tilted(0, 0, 1)) - w) / half};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sphere_on_a_slope_rolls_or_slides) {
  const double mu = 0.17, limit = std::atan(3.5 * mu);
  for (const double angle : {0.1 * limit, 0.9 * limit, 1.1 * limit, 1.3}) {
    const auto exact = ref::sphere_on_slope(angle, mu, 9.81);
    const Run run = on_slope(angle, mu, 0.03);
    BOOST_TEST(exact.slides == (angle > limit));
    within(run.acceleration / exact.acceleration, 1, 1e-3, "acceleration");
    // its spin turns the opposite way about +z as it goes down; arms are shorter by the overlap
    within(std::abs(run.surface) / exact.surface_acceleration, 1, 1e-3, "spin");
  }
}

BOOST_AUTO_TEST_CASE(rolling_friction_slows_a_rolling_sphere_and_holds_it) {
  const double mu_r = 0.013;
  const double exact = ref::rolling_deceleration(mu_r, 9.81);
  const Run slowing = on_slope(0, 0.4, 0.05, mu_r, -0.3);  // rolls: the spin goes with the velocity
  within(std::abs(slowing.acceleration) / exact, 1, 2e-3, "deceleration");
  // on a slope of less than mu_r it stays
  const Run held = on_slope(0.6 * mu_r, 0.4, 0.05, mu_r);
  within(held.acceleration / 9.81, 0, 1e-6, "held");
}

BOOST_AUTO_TEST_CASE(a_pair_that_turns_as_one_keeps_its_spring) {
  // a loaded contact carried around rigidly about a skew axis: the force on the first turns with it, its size
  // kept
  const V omega{31, -57, 23};
  const double dt = 1e-6;
  dem::HertzMindlin::Parameters<double> p = parameters({2e6, 7e5, 0.1, 0.9}, 1e-3, 1e-6, 1e-12, dt);
  dem::HertzMindlin::History<double> history{{}, std::sqrt(1e-5)};
  V n = tilted(1, 0, 0), t = tilted(0, 0.6, 0.8);
  dem::TouchingPair<double> pair{n, 1e-5, 1e-3 * t, {}, {}};
  for (int i = 0; i < 300; ++i) dem::HertzMindlin::act(p, pair, dt, history);
  const double size = norm(history.spring);
  BOOST_TEST(size > 1e-6);
  within(dot(history.spring, t), size, 1e-12 * size, "along the slip");
  const int steps = 40000;
  for (int i = 1; i <= steps; ++i) {
    const dem::Quaternion<double> turn = dem::rotation((i * dt) * omega);
    pair = {rotate(turn, n), 1e-5, {}, {}, omega};
    dem::HertzMindlin::act(p, pair, dt, history);
  }
  const V expected = size * rotate(dem::rotation((steps * dt) * omega), t);
  within(norm(history.spring - expected) / size, 0, 1e-4, "turned");
}

BOOST_AUTO_TEST_CASE(whatever_the_surfaces_do_the_tangential_contact_gives_no_energy) {
  // random slip at constant overlap, returning to where it began: work done on the contact less what its
  // spring holds
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  double least = 1;
  for (int trial = 0; trial < 300; ++trial) {
    const double dt = 1e-6, overlap = 1e-5, zeta = std::pow(10.0, -2 + trial % 5 * 0.5);
    const auto p = parameters({2e6, 7e5, zeta, 0.3}, 1e-3, 1e-6, 1e-12, dt);
    dem::HertzMindlin::History<double> history{{}, std::sqrt(overlap)};
    const double stiffness = p.tangential * std::sqrt(overlap);
    V slip{}, force{};
    double work = 0, moved = 0;
    for (int i = 0; i < 2000; ++i) {
      if (i % 37 == trial % 37)
        slip = std::pow(10.0, normal(generator)) * V{0, 0.1 * normal(generator), 0.1 * normal(generator)};
      if (i % 111 > 90) slip = V{};
      force = dem::HertzMindlin::act(p, {{1, 0, 0}, overlap, slip, {}, {}}, dt, history).force;
      work += dt * dot(force, slip);
      moved += dt * std::abs(dot(force, slip));
      least = std::min(least, (work + 1e-15) / (moved + 1e-15));
      BOOST_REQUIRE_LE(norm(V{0, force[1], force[2]}), 0.3 * -force[0] * (1 + 1e-12));
    }
    BOOST_TEST(work > 0.5 * dot(history.spring, history.spring) / stiffness);
  }
  BOOST_TEST(least >= 0);
}

BOOST_AUTO_TEST_CASE(lanes_do_what_a_double_does_to_the_bit) {
  using Pack = xsimd::batch<double, xsimd::sse2>;
  using P3 = dem::Vec<Pack, 3>;
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  const auto random = [&](double scale) {
    return V{scale * normal(generator), scale * normal(generator), scale * normal(generator)};
  };
  const auto packed = [](const V& a, const V& b) {
    return P3{Pack{a[0], b[0]}, Pack{a[1], b[1]}, Pack{a[2], b[2]}};
  };
  const double dt = 1e-6;
  const auto p = parameters({2e6, 7e5, 0.3, 0.4, 0.02}, 1e-3, 1e-6, 1e-12, dt);
  const dem::HertzMindlin::Parameters<Pack> pp{
      p.normal,   p.tangential, p.normal_damping, p.tangential_damping,
      p.friction, p.rolling,    p.rolling_limit,  p.extrapolation};
  for (int trial = 0; trial < 200; ++trial) {
    dem::TouchingPair<double> pair[2];
    dem::HertzMindlin::History<double> history[2];
    for (int k = 0; k < 2; ++k) {
      const V n = random(1);
      pair[k] = {(1 / norm(n)) * n, std::exp(normal(generator)) * 1e-6, random(0.1), random(10), random(10)};
      history[k] = {random(1e-5), trial % 3 == k ? 0.0 : std::exp(normal(generator)) * 1e-6};
    }
    const dem::TouchingPair<Pack> both{
        packed(pair[0].normal, pair[1].normal), Pack{pair[0].overlap, pair[1].overlap},
        packed(pair[0].velocity, pair[1].velocity), packed(pair[0].spin, pair[1].spin),
        packed(pair[0].mean_spin, pair[1].mean_spin)};
    dem::HertzMindlin::History<Pack> together{packed(history[0].spring, history[1].spring),
                                              Pack{history[0].sqrt_overlap, history[1].sqrt_overlap}};
    const auto action = dem::HertzMindlin::act(pp, both, Pack(dt), together);
    for (int k = 0; k < 2; ++k) {
      const auto alone = dem::HertzMindlin::act(p, pair[k], dt, history[k]);
      for (int c = 0; c < 3; ++c) {
        BOOST_TEST(action.force[c].get(k) == alone.force[c]);
        BOOST_TEST(action.moment[c].get(k) == alone.moment[c]);
        BOOST_TEST(together.spring[c].get(k) == history[k].spring[c]);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
