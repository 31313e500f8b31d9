// Maxwell branches against the integral of their relaxation in time; what becomes of two series beside one
// spring.
#include "dem/model/prony_series.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "dem/material/merge.hpp"
#include "dem/model/errors.hpp"

BOOST_AUTO_TEST_SUITE(prony_series_test)

namespace dem = fiberchain::dem;
using Complex = std::complex<double>;

namespace {

const dem::PronySeries three{{0.31, 0.7}, {0.07, 0.013}, {1.9, 4.1}};

/// s int_0^inf K(t) / K_inf exp(-s t) dt - 1 by Simpson's rule, t = exp(u).
Complex transformed(const dem::PronySeries& series, Complex s) {
  constexpr double low = -20, high = 6;
  constexpr int parts = 200000;
  Complex sum = 0;
  for (int i = 0; i <= parts; ++i) {
    const double t = std::exp(low + (high - low) * i / parts);
    double relaxing = 0;
    for (const auto& branch : series) relaxing += branch.strength * std::exp(-t / branch.time);
    const double weight = i == 0 || i == parts ? 1 : i % 2 == 0 ? 2 : 4;
    sum += weight * t * relaxing * std::exp(-s * t);
  }
  return s * sum * (high - low) / (3.0 * parts);
}

}  // namespace

BOOST_AUTO_TEST_CASE(modulus_is_the_transform_of_the_relaxation) {
  for (const Complex s : {Complex{0, 1.7}, Complex{0.4, 23.0}, Complex{-0.05, 0.3}}) {
    BOOST_TEST(std::abs(complex_modulus(three, s) - 1.0 - transformed(three, s)) < 2e-7);
  }
  const Complex K = complex_modulus(three, {0, 1.7});
  BOOST_TEST(storage_modulus(three, 1.7) == K.real(), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(loss_factor(three, 1.7) == K.imag() / K.real(), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(ends_of_the_spectrum) {
  BOOST_TEST(unrelaxed_modulus(three) == 3.28, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(storage_modulus(three, 1e200) == 3.28, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(storage_modulus(three, 0) == 1);
  BOOST_TEST(loss_factor(three, 0) == 0);
  BOOST_TEST(loss_factor(three, 1e-200) == 1e-200 * (0.31 * 0.7 + 0.07 * 0.013 + 1.9 * 4.1),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(dem::unrelaxed_modulus({}) == 1);
  BOOST_TEST(dem::loss_factor({}, 3.0) == 0);
}

BOOST_AUTO_TEST_CASE(senseless_branches_are_refused) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  BOOST_CHECK_NO_THROW(dem::check({{0, 1e-300}, {1e300, 2.0}}));
  for (const dem::MaxwellBranch branch : {dem::MaxwellBranch{-1e-9, 1}, {NAN, 1}, {infinite, 1}}) {
    BOOST_CHECK_THROW(dem::check({{1, 1}, branch}), dem::InvalidInput);
  }
  for (const double time : {0.0, -1.0, infinite, static_cast<double>(NAN)}) {
    BOOST_CHECK_THROW(dem::check({{1, time}}), dem::InvalidInput);
  }
}

BOOST_AUTO_TEST_CASE(two_series_beside_one_spring_add_what_they_take) {
  const dem::PronySeries two{{0.2, 0.7}, {0, 55.0}};
  const dem::PronySeries both = merge(three, two);
  BOOST_REQUIRE(both.size() == 3);  // 0.7 s is one branch, 55 s none
  BOOST_TEST((both[0].time == 4.1 && both[1].time == 0.7 && both[2].time == 0.013));
  const Complex s{-0.02, 0.9};
  const Complex expected = complex_modulus(three, s) + complex_modulus(two, s) - 1.0;
  BOOST_TEST(std::abs(complex_modulus(both, s) - expected) < 1e-15);
  BOOST_TEST(tidy(two).size() == 1);
  BOOST_TEST(dem::merge({}, {}).empty());
  BOOST_CHECK_THROW(merge(three, {{1, 0}}), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
