// A single frequency with a complex modulus: closed forms of the root, and the beam's frequencies.
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/complex_modes.hpp"

BOOST_AUTO_TEST_SUITE(single_mode_test)

namespace ref = fiberchain::reference;
using Complex = std::complex<double>;

BOOST_AUTO_TEST_CASE(free_free_frequencies) {
  // as in chain_modes_test: cos(beta) cosh(beta) = 1
  constexpr std::array<double, 3> beta{4.730040744862704, 7.853204624095838, 10.995607838001671};
  for (int n = 1; n <= 3; ++n) {
    BOOST_TEST(ref::free_free_beta(n) == beta[static_cast<std::size_t>(n - 1)],
               boost::test_tools::tolerance(1e-15));
  }
  for (int n = 1; n <= 20; ++n) {
    const double b = ref::free_free_beta(n);
    BOOST_TEST(std::abs(std::cos(b) - 1 / std::cosh(b)) < 1e-14 * b);
  }
}

BOOST_AUTO_TEST_CASE(a_dashpot_alone_has_no_difference) {
  // s^2 + omega^2 (1 + tau s) = 0: |s| = omega, zeta = tau omega/2
  const ref::FreeDecay decay =
      ref::single_mode_decay(7.3, ref::with_retardation(ref::elastic_modulus(), 0.05));
  BOOST_TEST(decay.frequency == 7.3, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(decay.damping == 0.05 * 7.3 / 2, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(decay.difference) < 1e-15);
  BOOST_TEST(std::abs(ref::single_mode_decay(7.3, ref::elastic_modulus()).damping) < 1e-15);
}

BOOST_AUTO_TEST_CASE(flat_loss_decays_faster_than_half_of_it) {
  // k = (s t)^a has the loss factor tan(a pi/2) at every frequency; s^(2 - a) = -omega^2 t^a gives
  // zeta = -cos(pi/(2 - a)), which is tan delta/2 (1 + tan delta/pi) to second order
  for (const double loss : {0.002, 0.02, 0.1, 0.4}) {
    const double a = 2 / std::numbers::pi * std::atan(loss);
    const auto flat = [a](Complex s) {
      const Complex value = std::pow(s * 0.9, a);
      return ref::ModulusValue{value, a * value / s};
    };
    const ref::FreeDecay decay = ref::single_mode_decay(31, flat);
    BOOST_TEST(decay.damping == -std::cos(std::numbers::pi / (2 - a)), boost::test_tools::tolerance(1e-11));
    BOOST_TEST(decay.half_loss_factor == loss / 2, boost::test_tools::tolerance(1e-12));
    const double relative = decay.difference / decay.half_loss_factor;
    BOOST_TEST_MESSAGE("flat loss " << loss << ": zeta above tan delta/2 by " << relative);
    BOOST_TEST(std::abs(relative / (loss / std::numbers::pi) - 1) < 1.1 * loss);
  }
}

BOOST_AUTO_TEST_SUITE_END()
