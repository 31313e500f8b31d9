// Arguments without a solution are refused, each with a message naming argument, value and what is allowed.
#include "reference/errors.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "reference/elastica.hpp"
#include "reference/gsl_ode.hpp"
#include "reference/gsl_root.hpp"
#include "reference/reissner.hpp"
#include "reference/ring.hpp"
#include "reference/small_deflection.hpp"

BOOST_AUTO_TEST_SUITE(reference_errors_test)

namespace ref = fiberchain::reference;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool names(const std::runtime_error& error, const std::string& part) {
  return std::string(error.what()).find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(loads_without_a_meaning_are_refused_by_every_solution) {
  const std::function<void(double)> solutions[] = {[](double load) { ref::elastica_shooting(load); },
                                                   [](double load) { ref::elastica_closed_form(load); },
                                                   [](double load) { ref::elastica_paper(load); },
                                                   [](double load) { ref::elastica_paper_singular(load); },
                                                   [](double load) { ref::elastica_shape(load, 5); },
                                                   [](double load) { ref::reissner_tip(load, 10, 10); },
                                                   [](double load) { ref::reissner_shape(load, 9, 9, 5); }};
  for (const auto& solve : solutions) {
    for (const double load : {-1e-9, -1.0, infinity, -infinity, not_a_number, 1e9}) {
      BOOST_CHECK_EXCEPTION(solve(load), ref::InvalidArgument, [](const auto& error) {
        return names(error, "load") && names(error, "allowed: ");
      });
    }
    BOOST_CHECK_NO_THROW(solve(0));
  }
}

BOOST_AUTO_TEST_CASE(message_names_argument_value_and_range) {
  BOOST_CHECK_EXCEPTION(ref::elastica_closed_form(-2.5), ref::InvalidArgument, [](const auto& error) {
    return std::string(error.what()) == "load is -2.5; allowed: finite, 0 to 50000";
  });
}

BOOST_AUTO_TEST_CASE(stiffnesses_and_lengths_must_be_positive) {
  for (const double bad : {0.0, -3.0, not_a_number}) {
    BOOST_CHECK_THROW(ref::reissner_tip(1, bad, 10), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::reissner_tip(1, 10, bad), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::reissner_cantilever(bad, 1, 1, 1, 1), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::reissner_cantilever(1, 1, 1, 1, bad), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::small_deflection(1, bad, 1, 1), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::small_deflection(1, 1, bad, 1), ref::InvalidArgument);
    BOOST_CHECK_THROW(ref::small_deflection(1, 1, 1, bad), ref::InvalidArgument);
  }
  BOOST_CHECK_THROW(ref::reissner_cantilever(infinity, 1, 1, 1, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::end_moment_tip(not_a_number), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::timoshenko_tip_y(1, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::small_deflection_tip_y(infinity), ref::InvalidArgument);
}

BOOST_AUTO_TEST_CASE(counts_are_checked) {
  BOOST_CHECK_THROW(ref::elastica_shape(1, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::reissner_shape(1, 1, 1, 0), ref::InvalidArgument);
  for (const int panels : {-4, 0, 3, 6, 202, 1000000}) {
    BOOST_CHECK_THROW(ref::elastica_paper(1, panels), ref::InvalidArgument);
  }
  BOOST_CHECK_THROW(ref::elastica_shooting(1, {.absolute = 0}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::elastica_shooting(1, {.relative = not_a_number}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::elastica_shooting(30, {.max_iterations = 1}), ref::NoConvergence);
}

BOOST_AUTO_TEST_CASE(failing_searches_and_integrations_throw_instead_of_aborting) {
  using namespace ref::detail;
  BOOST_CHECK_THROW(find_root([](double x) { return x * x + 1; }, -1, 1, {}, "x"), ref::NoConvergence);
  BOOST_CHECK_THROW(
      find_root([](double x) { return x < 0.3   ? -1
                                      : x > 0.7 ? 1
                                                : not_a_number; }, 0, 1, {}, "x"),
      ref::NoConvergence);
  const auto thrower = [](double x) -> double {
    if (x > 0.2 && x < 0.8) throw std::domain_error("inside");
    return x - 0.5;
  };
  BOOST_CHECK_THROW(find_root(thrower, 0, 1, {}, "x"), std::domain_error);
  BOOST_CHECK_THROW(find_root_newton(
                        [](double) {
                          return ValueSlope{1, 0};
                        },
                        1, 1e-8, 9, "x"),
                    ref::NoConvergence);
  const auto blow_up = [](double, const double* y, double* dy) { dy[0] = y[0] * y[0]; };
  std::array<double, 1> state{1};
  double t = 0;
  OdeIntegrator integrator(1, blow_up, {1e-12, 1e-12, 5000}, "blow-up");
  BOOST_CHECK_EXCEPTION(integrator.advance(t, 2, state), ref::NoConvergence,
                        [](const auto& error) { return names(error, "blow-up"); });
}

BOOST_AUTO_TEST_SUITE_END()
