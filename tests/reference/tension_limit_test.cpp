// The step that real tension allows where the bonds are solved within the step, against the amplification
// matrix with the tension in it.
#include "reference/tension_limit.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/amplification.hpp"
#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(tension_limit_test)

namespace ref = fiberchain::reference;
using ref::ChainEnds;
using ref::ChainMotion;
using std::numbers::pi;

namespace {

ref::LinearChain chain_of(double xi, double nu = 0.17) {
  return ref::with_bond_damping(ref::linear_chain({13, 1.7e-3, 3.1e6, nu, 870}), xi);
}

/// Largest radius over the waves, long ones as dense in the logarithm as short ones.
double largest_radius(const ref::LinearChain& chain, double beta, double tension, double dt) {
  double largest = 0;
  for (double phase = pi; phase > 1e-3; phase *= 0.98) {
    largest = std::max(
        largest, ref::wave_radius(chain, ref::bonds_in_step(beta), ChainMotion::bending, phase, dt, tension));
  }
  return largest;
}

/// Tension that stretches a bond by this part of its length.
double tension_of(const ref::LinearChain& chain, double strain) {
  return strain * chain.stiffness.stretch * chain.spacing;
}

}  // namespace

BOOST_AUTO_TEST_CASE(waves_leave_the_circle_where_tension_says) {
  for (const double xi : {0.0, 0.7}) {
    for (const double nu : {-0.2, 0.17, 0.49}) {
      const auto chain = chain_of(xi, nu);
      for (const double beta : {0.1, 0.25, 0.26, 0.3, 0.5}) {
        for (const double strain : {1e-5, 1e-3, 0.03, 0.4}) {
          const double tension = tension_of(chain, strain);
          const double dt = ref::tension_limited_step(chain, beta, tension);
          if (beta >= 0.25) BOOST_TEST(largest_radius(chain, beta, tension, 0.9999 * dt) < 1 + 1e-8);
          if (dt < 0.9999 * ref::endless_stable_step(chain, ref::bonds_in_step(beta)))
            BOOST_TEST(largest_radius(chain, beta, tension, 1.003 * dt) > 1 + 1e-5);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(at_beta_one_quarter_the_limit_is_that_of_a_string_of_beads) {
  const auto chain = chain_of(0.4);
  for (const double strain : {1e-6, 1e-3, 0.2}) {
    const double tension = tension_of(chain, strain);
    BOOST_TEST(
        ref::tension_limited_step(chain, 0.25, tension) == std::sqrt(chain.mass * chain.spacing / tension),
        boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(above_it_long_waves_decide_and_the_limit_goes_with_the_tension) {
  const auto chain = chain_of(0.4);
  for (const double beta : {0.27, 0.3, 0.5}) {
    const double tension = tension_of(chain, 1e-7);
    const double beam = 8 * std::sqrt((beta - 0.25) * chain.mass * chain.stiffness.bend) / tension;
    BOOST_TEST(ref::tension_limited_step(chain, beta, tension) == beam, boost::test_tools::tolerance(1e-4));
  }
}

BOOST_AUTO_TEST_CASE(without_tension_or_pushed_there_is_no_limit_of_it) {
  const auto chain = chain_of(0.4);
  for (const double tension : {0.0, -1e-3, -5.0}) {
    BOOST_TEST(std::isinf(ref::tension_limited_step(chain, 0.25, tension)));
    BOOST_TEST(std::isinf(ref::tension_limited_step(chain, 0.3, tension)));
    BOOST_TEST(ref::tension_limited_step(chain, 0.1, tension) ==
               ref::endless_stable_step(chain, ref::bonds_in_step(0.1)));
  }
}

BOOST_AUTO_TEST_CASE(finite_chains_leave_the_circle_where_their_pencil_says) {
  const auto chain = chain_of(0.4, -0.1);
  for (const auto ends : {ChainEnds::clamped_free, ChainEnds::free_free}) {
    for (const double beta : {0.1, 0.25, 0.3}) {
      for (const double strain : {1e-3, 0.05}) {
        const auto scheme = ref::bonds_in_step(beta);
        const double tension = tension_of(chain, strain);
        const double limit = ref::finite_stable_step(chain, scheme, ends, true, tension);
        const auto radius = [&](double dt) {
          return std::max(ref::chain_radius(chain, scheme, ChainMotion::bending, ends, dt, tension),
                          ref::chain_radius(chain, scheme, ChainMotion::axial, ends, dt, tension));
        };
        BOOST_TEST(radius(limit * (1 - 1e-5)) < 1 + 1e-8);
        BOOST_TEST(radius(limit * (1 + 1e-3)) > 1 + 1e-6);
        BOOST_TEST(
            ref::growth_per_step(chain, scheme, ends, 1.2 * limit, true, tension) == radius(1.2 * limit),
            boost::test_tools::tolerance(1e-9));
        BOOST_TEST(ref::growth_per_step(chain, scheme, ends, 0.999 * limit, true, tension) == 1);
      }
    }
  }
}

// A beam on an elastic foundation buckles at its free end under half the load of its middle (Hetenyi 1946).
BOOST_AUTO_TEST_CASE(a_pulled_free_end_halves_the_limit_of_long_waves) {
  auto chain = chain_of(0.4);
  chain.bonds = 10000;
  const double tension = tension_of(chain, 1e-6);
  const auto over_endless = [&](double beta) {
    return ref::finite_stable_step(chain, ref::bonds_in_step(beta), ChainEnds::free_free, true, tension) /
           ref::tension_limited_step(chain, beta, tension);
  };
  BOOST_TEST(over_endless(0.3) == 0.5, boost::test_tools::tolerance(0.01));
  BOOST_TEST(over_endless(0.25) == 1.0, boost::test_tools::tolerance(1e-5));  // shortest waves, no end
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const auto chain = chain_of(0);
  BOOST_CHECK_THROW(ref::tension_limited_step(chain, 1.5, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::tension_limited_step(chain, 0.3, std::nan("")), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
