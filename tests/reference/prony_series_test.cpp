// The generalized Maxwell stiffness and complex moduli: what is known of their limits, and their slopes.
#include "reference/prony_series.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(prony_series_test)

namespace ref = fiberchain::reference;
using Complex = std::complex<double>;

namespace {

const ref::PronySeries two_branches{{0.31, 0.7}, {0.045, 19}};

}  // namespace

BOOST_AUTO_TEST_CASE(one_branch_is_the_standard_linear_solid) {
  // K'/K_inf = 1 + g x^2/(1 + x^2), K''/K_inf = g x/(1 + x^2); the loss factor peaks at x = 1/sqrt(1 + g)
  // with g/(2 sqrt(1 + g))
  const double g = 0.31;
  const double tau = 0.7;
  const ref::ComplexModulus k = ref::complex_modulus({{g, tau}});
  for (const double x : {0.02, 0.9, 37.0}) {
    const Complex value = k({0, x / tau}).value;
    BOOST_TEST(value.real() == 1 + g * x * x / (1 + x * x), boost::test_tools::tolerance(1e-14));
    BOOST_TEST(value.imag() == g * x / (1 + x * x), boost::test_tools::tolerance(1e-14));
  }
  const double peak = 1 / (tau * std::sqrt(1 + g));
  BOOST_TEST(ref::loss_factor(k, peak) == g / (2 * std::sqrt(1 + g)), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ref::loss_factor(k, 1.1 * peak) < ref::loss_factor(k, peak));
  BOOST_TEST(ref::loss_factor(k, 0.9 * peak) < ref::loss_factor(k, peak));
}

BOOST_AUTO_TEST_CASE(relaxed_and_unrelaxed_are_the_limits) {
  const ref::ComplexModulus k = ref::complex_modulus(two_branches);
  BOOST_TEST(k(0).value == Complex(1, 0));
  BOOST_TEST(ref::unrelaxed_modulus(two_branches) == 1.355, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(k({0, 1e12}).value - 1.355) < 1e-11);
  BOOST_TEST(ref::unrelaxed_modulus({}) == 1);
  BOOST_TEST(ref::complex_modulus({})({-3, 2}).value == Complex(1, 0));
  BOOST_TEST(ref::elastic_modulus()({-3, 2}).value == Complex(1, 0));
}

BOOST_AUTO_TEST_CASE(modulus_is_the_transform_of_the_relaxation) {
  // k(s) = s int_0^inf (1 + sum g exp(-t/tau)) exp(-s t) dt, by the midpoint rule, s = 0.4 + 0.9 i
  const Complex s{0.4, 0.9};
  const double dt = 1e-3;
  Complex integral = 0;
  for (int i = 0; i < 100000; ++i) {
    const double t = (i + 0.5) * dt;
    double relaxation = 1;
    for (const ref::PronyTerm& term : two_branches) relaxation += term.strength * std::exp(-t / term.time);
    integral += relaxation * std::exp(-s * t) * dt;
  }
  const Complex k = ref::complex_modulus(two_branches)(s).value;
  BOOST_TEST(std::abs(s * integral - k) < 3e-7);
  BOOST_TEST(std::abs(k - 1.0) > 0.1);
}

BOOST_AUTO_TEST_CASE(slopes_are_derivatives) {
  const ref::ComplexModulus k = ref::with_retardation(ref::complex_modulus(two_branches), 0.08);
  const Complex s{-0.11, 0.6};
  const double h = 1e-5;
  BOOST_TEST(std::abs((k(s + h).value - k(s - h).value) / (2 * h) - k(s).slope) <
             1e-9 * std::abs(k(s).slope));
  BOOST_TEST(std::abs(k(s).value - ref::complex_modulus(two_branches)(s).value - 0.08 * s) < 1e-15);
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  BOOST_CHECK_THROW(ref::complex_modulus({{-0.1, 1}}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::complex_modulus({{0.1, 0}}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::complex_modulus({{0.1, INFINITY}}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::unrelaxed_modulus({{NAN, 1}}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::with_retardation(ref::elastic_modulus(), -1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::loss_factor(ref::elastic_modulus(), 0), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
