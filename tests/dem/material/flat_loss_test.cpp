// Flat loss factors: that no branches of the same number have a smaller largest error (Chebyshev's
// alternation), the ripple by Zolotarev's functions composed of each other, the storage modulus by the power
// law of a constant phase.
#include "dem/material/flat_loss.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "dem/material/equal_ripple.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/material/alternation.hpp"

BOOST_AUTO_TEST_SUITE(flat_loss_test)

namespace dem = fiberchain::dem;

namespace {

constexpr double turn = 2 * std::numbers::pi;

dem::FrequencyBand decades(double count) { return {7.3, 7.3 * std::pow(10, count)}; }

std::vector<double> extremes(const dem::FlatLoss& loss, double value, dem::FrequencyBand band) {
  return alternating_extremes([&](double f) { return loss_factor(loss.series, turn * f) / value - 1; },
                              band.low, band.high, 6000);
}

/// One branch takes 2 x / (1 + x^2), x from 1 / c to c: between 1 and 2 / (c + 1 / c), which halves around 1.
double ripple_of_one(double ratio) {
  const double c = std::sqrt(ratio), least = 2 / (c + 1 / c);
  return (1 - least) / (1 + least);
}

/// A best approximation of values between those of another one is the best of the product of their degrees.
double ripple_of_power_of_two(double ratio, int doublings) {
  double ripple = ripple_of_one(ratio);
  for (int i = 0; i < doublings; ++i) ripple = ripple_of_one((1 + ripple) / (1 - ripple));
  return ripple;
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_branches_of_the_same_number_are_flatter) {
  for (const double value : {3e-6, 0.017, 0.13, 0.5, 2.3}) {
    for (const double count : {0.3, 1.0, 3.0, 6.0}) {
      for (const int n : {1, 2, 3, 5, 8, 13, 16}) {
        const dem::FlatLoss loss = dem::flat_loss(value, decades(count), n);
        check(loss.series);
        if (loss.ripple < 1e-9) continue;
        const std::vector<double> found = extremes(loss, value, decades(count));
        BOOST_TEST(found.size() == 2u * n + 1, value << ", " << count << " decades, " << n << " branches");
        for (const double e : found) BOOST_TEST(e == loss.ripple, boost::test_tools::tolerance(1e-3));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(ripple_is_that_of_composed_best_approximations) {
  for (const double ratio : {1.9, 31.0, 1e3, 1e6, 1e12}) {
    for (int doublings = 0; doublings <= 4; ++doublings) {
      const double expected = ripple_of_power_of_two(ratio, doublings);
      const double ripple = dem::flat_loss(0.03, {0.2, 0.2 * ratio}, 1 << doublings).ripple;
      BOOST_TEST(std::abs(ripple - expected) <= 1e-12 * ratio / 1e6 * expected + 1e-10 * expected + 1e-15,
                 ratio << ", " << (1 << doublings) << ": " << ripple << ", " << expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(three_decades) {
  const auto ripple = [](int n) { return dem::flat_loss(0.02, {10, 1e4}, n).ripple; };
  BOOST_TEST(ripple(4) == 0.034258, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(ripple(5) == 0.010425, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(dem::flat_loss(0.02, {10, 1e4}).series.size() == 5);
}

BOOST_AUTO_TEST_CASE(fewest_branches_are_chosen) {
  for (const double count : {0.1, 1.0, 2.5, 4.0, 6.0, 12.0}) {
    const dem::FlatLoss loss = dem::flat_loss(0.11, decades(count));
    const int n = static_cast<int>(loss.series.size());
    BOOST_TEST(loss.ripple <= dem::good_ripple);
    if (n > 1) BOOST_TEST(dem::flat_loss(0.11, decades(count), n - 1).ripple > dem::good_ripple);
  }
}

BOOST_AUTO_TEST_CASE(exchange_from_elsewhere_finds_the_same_branches) {
  for (const double value : {1e-4, 0.02, 0.3}) {
    const dem::FrequencyBand band = decades(3);
    const dem::FlatLoss loss = dem::flat_loss(value, band, 4);
    dem::RippledSeries start{loss.series, {}, 0.3};
    for (int i = 0; i <= 8; ++i) start.extremes.push_back(turn * 7.3 * std::pow(10, 3 * i / 8.0));
    for (int j = 0; j < 4; ++j) {
      start.series[j].strength *= 1.3 - 0.2 * j;
      start.series[j].time *= 0.8 + 0.1 * j;
    }
    const dem::RippledSeries found = equal_ripple(start, {{}, value});
    BOOST_TEST(found.ripple == loss.ripple, boost::test_tools::tolerance(1e-6));
    for (std::size_t j = 0; j < 4; ++j) {
      BOOST_TEST(found.series[j].strength == loss.series[j].strength, boost::test_tools::tolerance(1e-6));
      BOOST_TEST(found.series[j].time == loss.series[j].time, boost::test_tools::tolerance(1e-6));
    }
  }
}

BOOST_AUTO_TEST_CASE(storage_modulus_rises_by_the_power_law_of_a_constant_phase) {
  for (const double value : {0.02, 0.3, 1.0}) {
    const double power = 2 / std::numbers::pi * std::atan(value);
    const dem::FlatLoss loss = dem::flat_loss(value, decades(6), 16);
    const double low = turn * 7.3e2, high = turn * 7.3e4;  // away from the ends of the band
    const double rise = storage_modulus(loss.series, high) / storage_modulus(loss.series, low);
    BOOST_TEST(std::log10(rise) == 2 * power, boost::test_tools::tolerance(1e-3));
    BOOST_TEST(std::log10(loss.rise) == 6 * power, boost::test_tools::tolerance(0.02));
  }
  BOOST_TEST(dem::flat_loss(0.02, {10, 1e4}, 5).rise == 1.0958, boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(branches_follow_the_band_and_small_losses_scale) {
  const dem::PronySeries a = dem::flat_loss(0.02, {10, 1e4}, 5).series;
  const dem::PronySeries b = dem::flat_loss(0.02, {10e-9, 1e-5}, 5).series;
  const dem::PronySeries small = dem::flat_loss(1e-9, {10, 1e4}, 5).series;
  const dem::PronySeries smaller = dem::flat_loss(1e-12, {10, 1e4}, 5).series;
  for (std::size_t j = 0; j < 5; ++j) {
    BOOST_TEST(b[j].strength == a[j].strength, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(b[j].time == 1e9 * a[j].time, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(small[j].strength == 1e3 * smaller[j].strength, boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(modulus_at_a_frequency) {
  const dem::PronySeries series{{0.41, 0.3}, {0.2, 0.002}};
  const double x = turn * 1.7 * 0.3, y = turn * 1.7 * 0.002;
  const double storage = 1 + 0.41 * x * x / (1 + x * x) + 0.2 * y * y / (1 + y * y);
  BOOST_TEST(dem::relaxed_part(series, 1.7) * storage == 1, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(dem::relaxed_part(series, 0) == 1);
  BOOST_TEST(dem::relaxed_part({}, 12.0) == 1);
  BOOST_CHECK_THROW(dem::relaxed_part(series, -1), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::relaxed_part(series, NAN), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(senseless_values_are_refused) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const double value : {0.0, -0.1, 10.1, infinite, static_cast<double>(NAN)}) {
    BOOST_CHECK_THROW(dem::flat_loss(value, {10, 1e4}), dem::InvalidInput);
  }
  for (const dem::FrequencyBand band :
       {dem::FrequencyBand{0, 1}, {-1, 1}, {2, 2}, {3, 2}, {1, infinite}, {NAN, 1}, {1, NAN}, {1, 1.1e12}}) {
    BOOST_CHECK_THROW(dem::flat_loss(0.1, band), dem::InvalidInput);
  }
  BOOST_CHECK_THROW(dem::flat_loss(0.1, {10, 1e4}, 0), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::flat_loss(0.1, {10, 1e4}, 33), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
