// Hertz's collision, the restitution of its dashpot, friction on rigid spheres: closed forms against
// integration.
#include "reference/hertz.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/cvode.hpp"
#include "reference/errors.hpp"
#include "reference/friction.hpp"

BOOST_AUTO_TEST_SUITE(hertz_test)

namespace ref = fiberchain::reference;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr ref::ElasticBody ball{0.83e-3, 2.4e-6, 2.6e6, 0.31}, other{1.37e-3, 1.9e-5, 7.1e6, 0.22},
    wall{infinite, infinite, 3.3e7, 0.41};

void close(double value, double expected, double tolerance, const char* what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance * std::abs(expected),
             what << ": " << value << ", expected " << expected);
}

/// The damped contact followed in y = 4/5 delta^(5/4) by time counted by delta^(1/4), unit frequency and
/// speed: speed when the force (or the overlap) has gone, by bisection on a short step.
double integrated_restitution(double zeta, ref::ContactEnd end) {
  const auto left = [&](double y, double v) {
    return end == ref::ContactEnd::zero_force ? y + 2 * zeta * v : y;
  };
  double t = 0, y = 0, v = 1;
  std::array<double, 2> state{y, v};
  for (double step = 0.01; step > 1e-12;) {
    ref::detail::Cvode cvode(
        ref::CvodeMethod::adams, [&](double, auto s, auto d) { d[0] = s[1], d[1] = -2 * zeta * s[1] - s[0]; },
        [&](double, auto, auto j) { j[2] = 1, j[1] = -1, j[3] = -2 * zeta; }, t, state, {1e-12, 1e-14},
        "oscillator");
    const auto next = cvode.advance(t + step);
    if (left(next[0], next[1]) < 0 && next[1] < 0) {
      step /= 2;
      continue;
    }
    state = {next[0], next[1]};
    t += step;
  }
  return -state[1];
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_pair_adds_compliances) {
  const ref::HertzPair pair = ref::hertz_pair(ball, other);
  close(1 / pair.modulus, (1 - 0.31 * 0.31) / 2.6e6 + (1 - 0.22 * 0.22) / 7.1e6, 1e-14, "E*");
  const double G1 = 2.6e6 / (2 * 1.31), G2 = 7.1e6 / (2 * 1.22);
  close(1 / pair.shear_modulus, 1.69 / G1 + 1.78 / G2, 1e-14, "G*");
  close(pair.radius, 0.83e-3 * 1.37e-3 / 2.2e-3, 1e-14, "R*");
  close(pair.mass, 2.4e-6 * 1.9e-5 / 2.14e-5, 1e-14, "m*");
  // two alike: E* = E / (2 (1 - nu^2)), R* = R / 2, and a mirror in the middle of a wall twice as stiff
  close(ref::hertz_pair(ball, ball).modulus, 2.6e6 / (2 * (1 - 0.31 * 0.31)), 1e-14, "E* of equals");
  const ref::HertzPair rigid = ref::hertz_pair(ball, {infinite, infinite, infinite, 0.3});
  close(rigid.modulus, 2.6e6 / (1 - 0.31 * 0.31), 1e-14, "E* on a rigid wall");
  BOOST_TEST(rigid.radius == 0.83e-3);
  BOOST_TEST(rigid.mass == 2.4e-6);
  // Mindlin's ratio of tangential to normal stiffness, 2 (1 - nu) / (2 - nu), for equals
  close(ref::mindlin_stiffness(ref::hertz_pair(ball, ball)) /
            (1.5 * ref::hertz_stiffness(ref::hertz_pair(ball, ball))),
        2 * 0.69 / 1.69, 1e-13, "Mindlin's ratio");
  BOOST_CHECK_THROW(ref::hertz_pair(wall, wall), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::hertz_pair({1, 1, 1, 0.6}, wall), ref::InvalidArgument);
}

BOOST_AUTO_TEST_CASE(collision_keeps_energy_and_takes_hertz_time) {
  close(ref::hertz_time_factor(), 2.94328, 2e-6, "time factor");
  for (const auto& [a, b] : {std::pair{ball, other}, {ball, wall}}) {
    const ref::HertzPair pair = ref::hertz_pair(a, b);
    const ref::HertzCollision hit = ref::hertz_collision(pair, 0.37);
    close(0.4 * ref::hertz_stiffness(pair) * std::pow(hit.overlap, 2.5), 0.5 * pair.mass * 0.37 * 0.37, 1e-13,
          "energy");
    close(hit.force, ref::hertz_stiffness(pair) * std::pow(hit.overlap, 1.5), 1e-13, "force");
    const ref::DampedCollision undamped = ref::damped_hertz_collision(pair, 0, 0.37);
    close(undamped.overlap, hit.overlap, 1e-13, "overlap without damping");
    close(undamped.time, hit.time, 1e-9, "time by quadrature");
    BOOST_TEST(undamped.restitution == 1);
    BOOST_TEST(undamped.overlap_left < 1e-10 * hit.overlap);
  }
  BOOST_CHECK_THROW(ref::hertz_collision(ref::hertz_pair(ball, wall), 0), ref::InvalidArgument);
}

BOOST_AUTO_TEST_CASE(restitution_follows_from_the_equation_of_motion) {
  for (const double zeta : {0.013, 0.28, 0.71, 0.999999, 1.3}) {
    for (const auto end : {ref::ContactEnd::zero_force, ref::ContactEnd::zero_overlap}) {
      if (zeta > 0.9 && end == ref::ContactEnd::zero_overlap) continue;
      close(ref::hertz_restitution(zeta, end), integrated_restitution(zeta, end), 1e-8, "restitution");
    }
  }
  BOOST_TEST(ref::hertz_restitution(1.3, ref::ContactEnd::zero_overlap) == 0);
  close(ref::hertz_restitution(1, ref::ContactEnd::zero_force), std::exp(-2.0), 1e-14, "critical");
}

BOOST_AUTO_TEST_CASE(the_common_formula_turns_40_percent_into_47) {
  const double zeta = ref::common_damping_ratio(0.4);
  close(ref::hertz_restitution(zeta, ref::ContactEnd::zero_overlap), 0.4, 1e-14, "with pull");
  close(ref::hertz_restitution(zeta, ref::ContactEnd::zero_force), 0.472, 1e-3, "without pull");
  BOOST_TEST(ref::common_damping_ratio(1) == 0);
  BOOST_CHECK_THROW(ref::common_damping_ratio(0), ref::InvalidArgument);
}

BOOST_AUTO_TEST_CASE(damping_leaves_less_overlap_and_more_time) {
  const ref::HertzPair pair = ref::hertz_pair(ball, other);
  const ref::HertzCollision hit = ref::hertz_collision(pair, 0.37);
  const ref::DampedCollision damped = ref::damped_hertz_collision(pair, 0.28, 0.37);
  BOOST_TEST(damped.overlap < hit.overlap);
  // force zero: k d^(5/4) = 2 zeta sqrt(5/4 m k) v e
  close(ref::hertz_stiffness(pair) * std::pow(damped.overlap_left, 1.25),
        2 * 0.28 * std::sqrt(1.25 * pair.mass * ref::hertz_stiffness(pair)) * 0.37 * damped.restitution,
        1e-12, "end");
}

BOOST_AUTO_TEST_CASE(friction_takes_what_impulse_and_momentum_say) {
  // momentum about the point of contact is kept: v_t - 2/5 R w
  const ref::ObliqueMotion before{-0.7, 0.11};
  for (const double mu : {0.05, 0.2, 3.0}) {
    const ref::FrictionImpact hit = ref::friction_impact(before, 0.3, mu, 0.45);
    const double slip = before.tangential + before.surface_spin,
                 left = hit.after.tangential + hit.after.surface_spin;
    close(hit.after.tangential - 0.4 * hit.after.surface_spin, before.tangential - 0.4 * before.surface_spin,
          1e-14, "moment");
    BOOST_TEST(hit.slides == (mu < 0.3));
    if (hit.slides) {
      close(hit.after.tangential, before.tangential + mu * 1.45 * 0.3, 1e-14, "impulse");
      close(left / slip, ref::sliding_slip_restitution(slip, 0.3, mu, 0.45), 1e-13, "slip");
    } else {
      BOOST_TEST(std::abs(left) < 1e-15);
    }
  }
  BOOST_CHECK_THROW(ref::friction_impact(before, -1, 0.2, 0.5), ref::InvalidArgument);
}

BOOST_AUTO_TEST_CASE(a_sphere_on_a_slope_rolls_up_to_seven_halves_of_friction) {
  const double mu = 0.13, limit = std::atan(3.5 * mu), g = 9.81;
  const auto rolls = ref::sphere_on_slope(limit - 1e-6, mu, g),
             slides = ref::sphere_on_slope(limit + 1e-6, mu, g);
  BOOST_TEST(!rolls.slides);
  BOOST_TEST(slides.slides);
  close(rolls.acceleration, slides.acceleration, 1e-5, "continuous");
  close(rolls.surface_acceleration, slides.surface_acceleration, 1e-5, "continuous spin");
  close(rolls.acceleration, 5.0 / 7 * g * std::sin(limit - 1e-6), 1e-14, "rolling");
  close(ref::sphere_on_slope(1.2, mu, g).acceleration, g * (std::sin(1.2) - mu * std::cos(1.2)), 1e-14,
        "sliding");
  BOOST_TEST(ref::sphere_on_slope(1.2, 0, g).surface_acceleration == 0);
  // moment mu_r R N against m a R + J a / R
  close(ref::rolling_deceleration(0.03, g) * (1 + 0.4), 0.03 * g, 1e-14, "rolling friction");
}

BOOST_AUTO_TEST_SUITE_END()
