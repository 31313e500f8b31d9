// Jeffery's equation: closed form, matrix exponential and CVODE against each other, and the equation itself.
#include "reference/jeffery.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(jeffery_test)

namespace ref = fiberchain::reference;
using ref::Direction;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double distance(const Direction& a, const Direction& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Direction unit(Direction p) {
  const double length = std::hypot(p[0], p[1], p[2]);
  for (double& x : p) x /= length;
  return p;
}

const ref::VelocityGradient odd_gradient{{{0.7, -0.31, 1.3}, {0.17, -0.9, 0.23}, {-0.8, 0.41, 0.2}}};

}  // namespace

BOOST_AUTO_TEST_CASE(closed_form_satisfies_the_equation) {
  const double rate = 2.3;
  for (const double r : {0.2, 1.0, 3.7, 25.5, 700.0}) {
    for (const Direction& start : {Direction{0.3, 0.5, 0.8}, {-1, 0.2, -0.4}, {0.6, -0.8, 0}, {0, 0, -1}}) {
      const ref::JefferyOrbit orbit = ref::jeffery_orbit(r, rate, start);
      BOOST_TEST(distance(ref::direction_on_orbit(orbit, 0), unit(start)) < 1e-15 * (10 + r));
      for (const double fraction : {0.0, 0.13, 0.5, 0.77}) {
        const double t = fraction * ref::jeffery_period(r, rate);
        const double h = 1e-3 / rate;
        const auto at = [&](double k) { return ref::direction_on_orbit(orbit, t + k * h); };
        const Direction slope =
            ref::jeffery_rate(ref::bretherton_constant(r), ref::simple_shear(rate), at(0));
        for (std::size_t i = 0; i < 3; ++i) {
          const double difference = (8 * (at(1)[i] - at(-1)[i]) - (at(2)[i] - at(-2)[i])) / (12 * h);
          BOOST_TEST(std::abs(difference - slope[i]) < 1e-12 * (100 + r) * rate,
                     "r " << r << " at " << fraction);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(orbit_closes_after_a_period_and_turns_over_after_half) {
  const ref::JefferyOrbit orbit = ref::jeffery_orbit(11.3, 0.7, {0.2, -0.5, 0.9});
  const double period = ref::jeffery_period(11.3, 0.7);
  BOOST_TEST(period == 2 * std::numbers::pi * (11.3 + 1 / 11.3) / 0.7, boost::test_tools::tolerance(1e-14));
  const Direction p = ref::direction_on_orbit(orbit, 1.9);
  BOOST_TEST(distance(ref::direction_on_orbit(orbit, 1.9 + 3 * period), p) < 1e-13);
  const Direction half = ref::direction_on_orbit(orbit, 1.9 + period / 2);
  BOOST_TEST(distance(half, {-p[0], -p[1], p[2]}) < 1e-13);
  BOOST_TEST(distance(ref::direction_on_orbit(orbit, 1.9 + 0.4 * period), p) > 0.1);
}

BOOST_AUTO_TEST_CASE(orbit_constant_is_constant_and_bounds_the_orbit) {
  const double r = 6.1;
  const ref::JefferyOrbit orbit = ref::jeffery_orbit(r, 1.1, {0.9, 0.1, -0.7});
  BOOST_TEST(orbit.reversed);
  double steepest = 0;
  double flattest = infinity;
  for (int k = 0; k < 400; ++k) {
    const Direction p = ref::direction_on_orbit(orbit, k * ref::jeffery_period(r, 1.1) / 400);
    BOOST_TEST(ref::orbit_constant(r, p) == orbit.constant, boost::test_tools::tolerance(1e-12));
    const double tangent = std::hypot(p[0], p[1]) / std::abs(p[2]);
    steepest = std::max(steepest, tangent);
    flattest = std::min(flattest, tangent);
  }
  // tan(theta) runs from C (in the plane of gradient and vorticity) to C r
  BOOST_TEST(std::abs(flattest / orbit.constant - 1) < 1e-3);
  BOOST_TEST(std::abs(steepest / (r * orbit.constant) - 1) < 1e-3);
  BOOST_TEST(ref::orbit_constant(r, {0.6, 0.8, 0}) == infinity);
  BOOST_TEST(ref::orbit_constant(r, {0, 0, 3}) == 0);
  BOOST_TEST(ref::bounded_orbit_constant(infinity) == 1);
  BOOST_TEST(ref::bounded_orbit_constant(3) == 0.75);
}

BOOST_AUTO_TEST_CASE(cvode_and_exponential_agree_with_the_closed_form) {
  const double r = 7.4;
  const double rate = 1.7;
  const double lambda = ref::bretherton_constant(r);
  const Direction start{0.3, 0.5, 0.8};
  const ref::JefferyOrbit orbit = ref::jeffery_orbit(r, rate, start);
  const std::vector<double> times{0, 3.1, 20, 1.5 * ref::jeffery_period(r, rate)};
  const auto history = ref::jeffery_by_cvode(lambda, ref::simple_shear(rate), start, times, {1e-12, 1e-14});
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Direction exact = ref::direction_on_orbit(orbit, times[k]);
    BOOST_TEST(distance(history.directions[k], exact) < 3e-9, "t " << times[k]);
    BOOST_TEST(distance(ref::jeffery_by_exponential(lambda, ref::simple_shear(rate), start, times[k]),
                        exact) < 1e-11);
  }
  BOOST_TEST(history.statistics.steps > 50);
  const auto loose = ref::jeffery_by_cvode(lambda, ref::simple_shear(rate), start, times, {1e-5, 1e-7});
  const double error = distance(loose.directions.back(), ref::direction_on_orbit(orbit, times.back()));
  BOOST_TEST(error < 1e-1);
  BOOST_TEST(error > 1e-7);
}

BOOST_AUTO_TEST_CASE(any_gradient_by_two_ways) {
  for (const double lambda : {-0.8, 0.0, 0.93, 1.0, 1.4}) {
    const std::vector<double> times{0.4, 2.7, 9.1};
    const auto history = ref::jeffery_by_cvode(lambda, odd_gradient, {1, 2, -0.5}, times, {1e-12, 1e-14});
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Direction exact = ref::jeffery_by_exponential(lambda, odd_gradient, {1, 2, -0.5}, times[k]);
      BOOST_TEST(distance(history.directions[k], exact) < 2e-9, "Lambda " << lambda);
    }
  }
}

BOOST_AUTO_TEST_CASE(planar_extension_draws_the_axis_into_its_direction) {
  // tan(angle to x) falls as exp(-2 Lambda e t)
  ref::VelocityGradient extension{};
  extension[0][0] = 0.9;
  extension[1][1] = -0.9;
  const double lambda = 0.7;
  const auto history = ref::jeffery_by_cvode(lambda, extension, {0.3, 0.8, 0}, {1.3});
  const double tangent = history.directions[0][1] / history.directions[0][0];
  BOOST_TEST(tangent == 0.8 / 0.3 * std::exp(-2 * lambda * 0.9 * 1.3), boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(changing_shear_moves_by_the_strain_alone) {
  // rate(t) = g cos(w t): the place on the orbit follows the strain (g/w) sin(w t)
  const double g = 5;
  const double w = 2.1;
  const double r = 4.5;
  const auto gradient = [&](double t) { return ref::simple_shear(g * std::cos(w * t)); };
  const Direction start{0.4, 0.6, 0.3};
  const auto history =
      ref::jeffery_by_cvode(ref::bretherton_constant(r), gradient, start, {0.5, 2.9, 7.7}, {1e-12, 1e-14});
  const ref::JefferyOrbit orbit = ref::jeffery_orbit(r, 1, start);
  std::size_t k = 0;
  for (const double t : {0.5, 2.9, 7.7}) {
    const Direction exact = ref::direction_on_orbit(orbit, g / w * std::sin(w * t));
    BOOST_TEST(distance(history.directions[k++], exact) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(axial_spin_is_the_mean_of_the_fluid_s) {
  const double rate = 1.9;
  for (const double r : {0.3, 5.0, 36.0}) {
    for (const Direction& start : {Direction{0.3, 0.5, 0.8}, {0.1, 0.1, -2}, {0.9, 0.3, 0.01}}) {
      const ref::JefferyOrbit orbit = ref::jeffery_orbit(r, rate, start);
      const int count = 20000;  // mean of a smooth periodic function: converges exponentially
      double sum = 0;
      for (int k = 0; k < count; ++k) {
        sum -= rate / 2 * ref::direction_on_orbit(orbit, k * ref::jeffery_period(r, rate) / count)[2];
      }
      BOOST_TEST(ref::mean_axial_spin(orbit) == sum / count, boost::test_tools::tolerance(1e-9));
    }
  }
  BOOST_TEST(ref::mean_axial_spin(ref::jeffery_orbit(3, rate, {1, 1, 0})) == 0);
  BOOST_TEST(ref::mean_axial_spin(ref::jeffery_orbit(3, rate, {0, 0, 1})) == -rate / 2);
}

BOOST_AUTO_TEST_CASE(free_draining_chain) {
  for (const int n : {1, 2, 3, 11, 20, 50, 101, 999}) {
    const double r = ref::free_draining_aspect_ratio(n);
    BOOST_TEST(std::abs(ref::bretherton_constant(r) - ref::free_draining_bretherton(n)) < 1e-14);
    BOOST_TEST(ref::equivalent_aspect_ratio(ref::free_draining_bretherton(n)) == r,
               boost::test_tools::tolerance(1e-9));
  }
  const auto period = [](int n) { return ref::jeffery_period(ref::free_draining_aspect_ratio(n), 1); };
  BOOST_TEST(std::abs(period(11) - 49.88) < 0.005);
  BOOST_TEST(std::abs(period(20) - 89.41) < 0.005);
  BOOST_TEST(std::abs(period(50) - 222.37) < 0.005);
}

BOOST_AUTO_TEST_CASE(correlations) {
  BOOST_TEST(ref::cox_aspect_ratio(50) == 62 / std::sqrt(std::log(50.0)));
  BOOST_TEST(ref::goldsmith_mason_aspect_ratio(50) == 32.85, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ref::harris_pittman_aspect_ratio(17) == 1.14 * std::exp(0.844 * std::log(17.0)),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ref::zhang_aspect_ratio(20) == 0.28 - 1.868 + 15.28 + 0.404,
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ref::aspect_ratio_correlations().size() == 4U);
  // free draining's period at N = r = 50 over Cox's: 12.8 %
  const double over = ref::jeffery_period(ref::free_draining_aspect_ratio(50), 1) /
                      ref::jeffery_period(ref::cox_aspect_ratio(50), 1);
  BOOST_TEST(std::abs(over - 1.128) < 0.0006);
}

BOOST_AUTO_TEST_CASE(correlations_hold_together_and_within_their_range) {
  for (const auto& each : ref::aspect_ratio_correlations()) {
    BOOST_TEST(!each.source.empty());
    BOOST_TEST(!each.range.empty());
    const double high = std::min(each.high, 1e4);
    double before = 0;
    for (int k = 0; k <= 500; ++k) {
      const double r = std::min(high, each.low * std::pow(high / each.low, k / 500.0));
      const double r_e = each.function(std::max(r, each.low));
      BOOST_TEST((r_e >= 1 && r_e <= r * (1 + 1e-12) && r_e > before), each.name << " at " << r);
      before = r_e;
    }
    BOOST_CHECK_THROW(each.function(each.low * 0.999), ref::InvalidArgument);
    if (std::isfinite(each.high)) BOOST_CHECK_THROW(each.function(each.high * 1.001), ref::InvalidArgument);
    BOOST_CHECK_THROW(each.function(not_a_number), ref::InvalidArgument);
    // all of them fit measurements or computations of cylinders: 6 % at r = 20 to 50
    for (const double r : {20.0, 35.0, 50.0}) {
      BOOST_TEST(std::abs(each.function(r) / ref::cox_aspect_ratio(r) - 1) < 0.06, each.name << " at " << r);
    }
  }
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  for (const double bad : {0.0, -2.0, not_a_number, infinity}) {
    BOOST_CHECK_THROW(ref::bretherton_constant(bad), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::jeffery_period(bad, 1), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::jeffery_period(3, bad), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::jeffery_orbit(3, bad, {1, 0, 0}), ref::InvalidArgument);
  }
  BOOST_CHECK_THROW(ref::equivalent_aspect_ratio(1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::equivalent_aspect_ratio(-1.2), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::equivalent_aspect_ratio(not_a_number), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::orbit_constant(3, {0, 0, 0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::orbit_constant(3, {1, not_a_number, 0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::bounded_orbit_constant(-0.1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::direction_on_orbit({3, 1, -1, 0}, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::jeffery_by_cvode(0.5, ref::simple_shear(1), {1, 0, 0}, {2, 1}),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::jeffery_by_cvode(not_a_number, ref::simple_shear(1), {1, 0, 0}, {1}),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::jeffery_by_exponential(0.5, ref::simple_shear(1), {1, 0, 0}, 1e4),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::free_draining_bretherton(0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::free_draining_aspect_ratio(-3), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
