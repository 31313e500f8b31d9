// One step of a scheme for one damped oscillator: roots, stable region, leading errors.
#include "reference/time_scheme.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(time_scheme_test)

namespace ref = fiberchain::reference;
using ref::TimeScheme;
using complex = std::complex<double>;

namespace {

constexpr TimeScheme schemes[] = {ref::lagged_dashpots,    ref::damped_in_step,      {0.3, 0.1},
                                  ref::bonds_in_step(0.2), ref::bonds_in_step(0.25), ref::bonds_in_step(0.3)};

/// Displacement after `steps` steps from displacement 1 and velocity `v` half a step before, w = 1.
double marched(const TimeScheme& scheme, double dt, double damping, double v, int steps) {
  double u = 1;
  const double mass = 1 + 2 * scheme.theta * dt * damping + scheme.beta * dt * dt;
  for (int i = 0; i < steps; ++i) {
    v -= dt * (u + 2 * damping * v) / mass;
    u += dt * v;
  }
  return u;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_root_s_motion_is_what_the_scheme_marches) {
  for (const TimeScheme& scheme : schemes) {
    for (const auto& [dt, damping] : {std::pair{0.3, 0.0}, {0.7, 0.11}, {0.2, 1.7}}) {
      const complex z = ref::step_root(scheme, dt, damping);
      // u_0 = 1, u_1 = z: where z is complex, its real part of a motion with both roots
      const complex before = 1.0 / z;
      const double u = marched(scheme, dt, damping, (1 - before.real()) / dt, 7);
      BOOST_TEST(u == std::pow(z, 7).real(), boost::test_tools::tolerance(1e-11));
    }
  }
}

// A fine grid over w dt and damping: |z| <= 1 left of the limit, a real z < -1 right of it.
BOOST_AUTO_TEST_CASE(roots_leave_the_circle_where_the_stable_region_ends) {
  for (const TimeScheme& scheme : schemes) {
    for (const double damping : {0.0, 0.03, 0.4, 1.0, 6.0}) {
      const double limit = ref::stable_angle(scheme, damping);
      const double last = std::isinf(limit) ? 1e4 : limit;
      for (const double part : {1e-3, 0.1, 0.5, 0.9, 1 - 1e-7}) {
        const double size = std::abs(ref::step_root(scheme, part * last, damping));
        BOOST_TEST(size < 1 + 1e-12);
        if (damping == 0) BOOST_TEST(size > 1 - 1e-12);
      }
      if (std::isinf(limit)) continue;
      for (const double part : {1 + 1e-7, 1.2, 30.0}) {
        const complex z = ref::step_root(scheme, part * limit, damping);
        BOOST_TEST(z.real() < -1 - 1e-9);
        BOOST_TEST(z.imag() == 0);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(stable_region_in_numbers) {
  BOOST_TEST(ref::stable_angle(ref::damped_in_step, 0.8) == 2, boost::test_tools::tolerance(1e-14));
  // 1 - h - h^2/4 = 0
  BOOST_TEST(ref::stable_angle(ref::lagged_dashpots, 1) == 2 * (std::numbers::sqrt2 - 1),
             boost::test_tools::tolerance(1e-14));
  for (const double beta : {0.05, 0.17, 0.2499}) {
    BOOST_TEST(ref::stable_angle(ref::bonds_in_step(beta), 0.2) == 1 / std::sqrt(0.25 - beta),
               boost::test_tools::tolerance(1e-12));
  }
  BOOST_TEST(std::isinf(ref::stable_angle(ref::bonds_in_step(0.25), 0)));
  BOOST_TEST(std::isinf(ref::stable_angle(ref::bonds_in_step(0.3), 2)));
  BOOST_TEST(std::isinf(ref::stable_angle({0, 0.3}, 0.1)));  // 1 - h/10 + h^2/20 > 0
  BOOST_TEST(ref::stable_angle({0, 0.3}, 1) == 2 / (1 + std::sqrt(0.8)), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(errors_of_a_mode_follow_their_law) {
  for (const TimeScheme& scheme : schemes) {
    for (const double damping : {1e-4, 3e-3}) {
      for (const double angle : {0.01, 0.04, 0.16}) {
        const complex exponent = std::log(ref::step_root(scheme, angle, damping));
        const double frequency = std::abs(exponent) / angle - 1;
        const double ratio = -exponent.real() / std::abs(exponent) / damping - 1;
        const ref::ModeError law = ref::error_law(scheme, angle, damping);
        const double left_out = std::pow(angle, 4) / 5 + std::pow(angle, 3) * damping +
                                std::pow(angle * damping, 2) * 4 + 1e-15 / (damping * angle);
        BOOST_TEST(std::abs(frequency - law.frequency) < left_out);
        BOOST_TEST(std::abs(ratio - law.damping) < left_out);
        BOOST_TEST(left_out < 0.2 * std::abs(law.damping));  // so that the law is seen
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_law_in_numbers) {
  // a step of T/90 at beta = 0.3: damping within 0.1 %
  const double angle = 2 * std::numbers::pi / 90;
  BOOST_TEST(ref::error_law(ref::bonds_in_step(0.3), angle, 0).damping == -9.3411e-4,
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(ref::error_law(ref::bonds_in_step(0.3), angle, 0).frequency == -5.2799e-4,
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(ref::error_law(ref::bonds_in_step(1.0 / 12), 0.1, 0.02).frequency == 0);
  BOOST_TEST(ref::error_law(ref::lagged_dashpots, 0.1, 0.02).damping == 0.001 - 0.01 / 24,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  BOOST_CHECK_THROW(ref::step_root({0.5, -0.1}, 1, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::step_root(ref::damped_in_step, 0, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::stable_angle({0.51, 0}, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::stable_angle(ref::damped_in_step, -1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::error_law(ref::damped_in_step, 0.1, std::nan("")), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
