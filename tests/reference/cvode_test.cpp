// The one door to SUNDIALS: exact solutions, counters, failures that come through as exceptions.
#include "reference/cvode.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(cvode_test)

namespace ref = fiberchain::reference;
using ref::detail::Cvode;

namespace {

constexpr double omega = 2.3;

// y'' + omega^2 y = 0
void oscillator(double, std::span<const double> y, std::span<double> d) {
  d[0] = y[1];
  d[1] = -omega * omega * y[0];
}

void oscillator_jacobian(double, std::span<const double>, std::span<double> j) {
  j[2] = 1;
  j[1] = -omega * omega;
}

double error_after_five_periods(ref::CvodeMethod method, double tolerance) {
  const std::array<double, 2> start{1, 0};
  Cvode cvode(method, oscillator, oscillator_jacobian, 0, start, {tolerance, tolerance / 100}, "oscillator");
  return std::abs(cvode.advance(10 * std::numbers::pi / omega)[0] - 1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(error_follows_the_tolerance) {
  for (const auto method : {ref::CvodeMethod::bdf, ref::CvodeMethod::adams}) {
    const double loose = error_after_five_periods(method, 1e-5);
    const double tight = error_after_five_periods(method, 1e-10);
    BOOST_TEST(tight < 1e-6);
    BOOST_TEST(tight > 1e-16);
    BOOST_TEST(loose > 10 * tight);
  }
}

BOOST_AUTO_TEST_CASE(counters_count) {
  const std::array<double, 2> start{1, 0};
  int called = 0;
  const auto counted = [&](double t, std::span<const double> y, std::span<double> d) {
    ++called;
    oscillator(t, y, d);
  };
  Cvode cvode(ref::CvodeMethod::bdf, counted, oscillator_jacobian, 0, start, {}, "oscillator");
  BOOST_TEST(cvode.statistics().steps == 0);
  cvode.advance(3);
  const ref::CvodeStatistics s = cvode.statistics();
  BOOST_TEST(s.steps > 100);
  BOOST_TEST(s.right_hand_sides == called);
  BOOST_TEST(s.jacobians >= 1);
  BOOST_TEST(s.linear_setups >= s.jacobians);
  BOOST_TEST(s.newton_iterations >= s.steps);
}

BOOST_AUTO_TEST_CASE(a_wrong_jacobian_costs_and_a_right_one_does_not) {
  // stiff relaxation to cos(t) at rate 1e4
  const auto rhs = [](double t, std::span<const double> y, std::span<double> d) {
    d[0] = -1e4 * (y[0] - std::cos(t)) - std::sin(t);
  };
  const auto iterations = [&](double entry) {
    const std::array<double, 1> start{1};
    Cvode cvode(
        ref::CvodeMethod::bdf, rhs, [&](double, auto, std::span<double> j) { j[0] = entry; }, 0, start, {},
        "relaxation");
    BOOST_TEST(std::abs(cvode.advance(2)[0] - std::cos(2.0)) < 1e-7);
    return cvode.statistics().newton_iterations;
  };
  BOOST_TEST(iterations(-1e4) < iterations(-1.5e4));
}

BOOST_AUTO_TEST_CASE(failures_become_exceptions) {
  const std::array<double, 2> start{1, 0};
  const auto throwing = [](double t, std::span<const double>, std::span<double> d) {
    if (t > 0.5) throw std::domain_error("late");
    d[0] = d[1] = 0;
  };
  Cvode thrower(ref::CvodeMethod::bdf, throwing, oscillator_jacobian, 0, start, {}, "thrower");
  BOOST_CHECK_THROW(thrower.advance(2), std::domain_error);
  Cvode short_of_steps(ref::CvodeMethod::bdf, oscillator, oscillator_jacobian, 0, start, {1e-10, 1e-12, 20},
                       "short run");
  BOOST_CHECK_EXCEPTION(short_of_steps.advance(100), ref::NoConvergence, [](const auto& error) {
    const std::string what = error.what();
    return what.find("short run") != std::string::npos && what.find("CV_TOO_MUCH_WORK") != std::string::npos;
  });
  for (const double bad : {0.0, -1e-8, std::nan("")}) {
    BOOST_CHECK_THROW(
        Cvode(ref::CvodeMethod::bdf, oscillator, oscillator_jacobian, 0, start, {bad, 1e-9}, "x"),
        ref::InvalidArgument);
    BOOST_CHECK_THROW(
        Cvode(ref::CvodeMethod::bdf, oscillator, oscillator_jacobian, 0, start, {1e-9, bad}, "x"),
        ref::InvalidArgument);
  }
}

BOOST_AUTO_TEST_SUITE_END()
