// Strengths that differ from bond to bond: of a fiber of a length, whatever the bonds it is cut into.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/insertion/random_numbers.hpp"
#include "tests/dem/assembly/breaking_scenes.hpp"

BOOST_AUTO_TEST_SUITE(weibull_test)

using namespace scenes;

namespace {

constexpr double modulus = 5.3, reference_length = 0.31, strength = 4.1e3;

/// Fibers of this length, drawn to the same stress all along.
dem::Assembly drawn_fibers(double length, int bonds, double stress, int count, std::uint64_t seed) {
  dem::Fiber fiber = odd_fiber(bonds);
  fiber.diameter = length / bonds;
  fiber.strength =
      dem::BondStrength{.tension = strength, .weibull = dem::WeibullSpread{modulus, reference_length, seed}};
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const double strain = stress / fiber.material.youngs_modulus;
  dem::FiberGroup group{chain, {}};
  for (int f = 0; f < count; ++f)
    group.fibers.push_back(strained(
        chain,
        [&](int i) {
          return V{i * strain * fiber.diameter, f * 2 * fiber.diameter, 0};
        },
        [](int) { return V{}; }));
  return {{group}, {}, {.form = dem::BondForm::total}};
}

/// Fibers with a bond that broke at once, all under the same stress.
double part_broken(double length, int bonds, double stress, int count, std::uint64_t seed) {
  dem::Assembly assembly = drawn_fibers(length, bonds, stress, count, seed);
  assembly.march(1);
  int broken = 0;
  for (int f = 0; f < count; ++f) {
    bool any = false;
    for (int i = 0; i < bonds; ++i) any = any || assembly.is_broken(0, f, i);
    broken += any ? 1 : 0;
  }
  return static_cast<double>(broken) / count;
}

}  // namespace

/// 1 - exp(-(L/l_0) (sigma/S)^m), within three standard deviations of 3000 fibers.
BOOST_AUTO_TEST_CASE(refining_a_fiber_does_not_change_its_strength) {
  const int count = 3000;
  for (const double length : {0.31, 0.62}) {
    for (const double stress : {0.8 * strength, 1.0 * strength}) {
      const double expected = 1 - std::exp(-length / reference_length * std::pow(stress / strength, modulus));
      const double deviation = std::sqrt(expected * (1 - expected) / count);
      for (const int bonds : {3, 13, 31}) {
        const double part = part_broken(length, bonds, stress, count, 7);
        BOOST_TEST(std::abs(part - expected) < 3 * deviation,
                   bonds << " bonds: " << part << ", expected " << expected << " +- " << deviation);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(strengths_are_functions_of_seed_fiber_and_bond) {
  const auto broken = [](int count, std::uint64_t seed) {
    dem::Assembly assembly = drawn_fibers(0.31, 11, 0.9 * strength, count, seed);
    assembly.march(1);
    std::vector<bool> all;
    for (int f = 0; f < 20; ++f)
      for (int i = 0; i < 11; ++i) all.push_back(assembly.is_broken(0, f, i));
    return all;
  };
  BOOST_TEST((broken(20, 3) == broken(61, 3)));
  BOOST_TEST((broken(20, 3) != broken(20, 4)));
}

/// A factor's mean is Gamma(1 + 1/m) of its scale, its median (ln 2)^(1/m).
BOOST_AUTO_TEST_CASE(factors_have_the_law_of_weibull) {
  const dem::WeibullSpread spread{modulus, 0.31};
  BOOST_TEST(std::abs(dem::weibull_factor(spread, 0.031, 0.5) / std::pow(10 * std::log(2.0), 1 / modulus) -
                      1) < 1e-14);
  double sum = 0;
  const int count = 40000;
  for (int n = 0; n < count; ++n)
    sum +=
        dem::weibull_factor(spread, 0.31, dem::uniform_numbers(5, {static_cast<std::uint64_t>(n), 0, 0})[1]);
  BOOST_TEST(std::abs(sum / count - std::tgamma(1 + 1 / modulus)) < 4 * 0.22 / std::sqrt(count));
}

BOOST_AUTO_TEST_SUITE_END()
