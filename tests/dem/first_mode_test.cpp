// The first bending mode that dem/ finds by inverse iteration against the eigenvalues of the linear chain
// (reference/).
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "dem/model/errors.hpp"
#include "dem/vibration/first_mode.hpp"
#include "reference/chain_modes.hpp"

BOOST_AUTO_TEST_SUITE(first_mode_test)

namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;

namespace {

dem::Fiber fiber(int bonds, double bond_damping) {
  return {.material = dem::isotropic_material(3.1e6, 0.17, 1300),
          .diameter = 1.3e-3,
          .aspect_ratio = bonds,
          .bond_damping = bond_damping};
}

reference::LinearChain chain_of(int bonds) {
  return reference::linear_chain({bonds, 0.65e-3, 3.1e6, 0.17, 1300});
}

/// K's entries of stretch exceed its lowest eigenvalue by 16 r_f^3 and more: so many digits are rounded away.
double tolerance_of(int bonds) { return 1e-14 * std::pow(bonds, 3); }

}  // namespace

BOOST_AUTO_TEST_CASE(undamped_its_frequency_is_the_linear_chains) {
  for (const int bonds : {2, 13, 150}) {
    const dem::FirstMode mode = dem::first_mode(fiber(bonds, 0));
    const auto exact = reference::first_bending_mode(chain_of(bonds));
    BOOST_CHECK_CLOSE_FRACTION(mode.frequency, exact.frequency, tolerance_of(bonds));
    BOOST_TEST(mode.damping == 0);
  }
}

BOOST_AUTO_TEST_CASE(its_damping_is_exact_to_second_order_in_the_dashpots) {
  double previous = 0;
  for (const double bond_damping : {2.0, 1.0, 0.5}) {
    const dem::FirstMode mode = dem::first_mode(fiber(13, bond_damping));
    const auto exact =
        reference::first_bending_mode(reference::with_bond_damping(chain_of(13), bond_damping));
    const double error = std::abs(mode.damping / exact.damping - 1);
    BOOST_TEST_MESSAGE("xi_b = " << bond_damping << ": " << error);
    BOOST_TEST(error < 1e-8 * bond_damping * bond_damping);
    if (previous != 0) BOOST_TEST(std::abs(std::log2(previous / error) - 2) < 0.1);
    previous = error;
    BOOST_CHECK_CLOSE_FRACTION(mode.period, 2 * std::numbers::pi / exact.eigenvalue.imag(), 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(an_overdamped_mode_has_no_period) {
  BOOST_CHECK_THROW(dem::first_mode(fiber(6, 1e4)), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
