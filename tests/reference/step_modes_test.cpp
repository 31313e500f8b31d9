// Modes of the marched chain against those of the chain itself: error laws, scalar roots, spectral radius.
#include "reference/step_modes.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/amplification.hpp"
#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(step_modes_test)

namespace ref = fiberchain::reference;
using ref::ChainEnds;
using ref::ChainMotion;
using ref::TimeScheme;

namespace {

constexpr TimeScheme schemes[] = {ref::lagged_dashpots, ref::damped_in_step, ref::bonds_in_step(0.25),
                                  ref::bonds_in_step(0.3)};

ref::LinearChain undamped(int bonds) { return ref::linear_chain({bonds, 1.7e-3, 3.1e6, 0.17, 870}); }

}  // namespace

// Where C is a multiple of K, modes are the undamped ones' and each is an oscillator, however large the step.
BOOST_AUTO_TEST_CASE(with_one_retardation_time_every_mode_is_an_oscillator) {
  const auto plain = undamped(13);
  const double tau = 0.2 * ref::bond_time(plain);
  const auto chain = ref::with_retardation_time(plain, tau);
  for (const auto ends : {ChainEnds::clamped_free, ChainEnds::free_free}) {
    for (const auto motion : {ChainMotion::bending, ChainMotion::axial, ChainMotion::twist}) {
      const auto modes = ref::chain_modes(plain, motion, ends);
      for (const double ratio : {0.3, 4.0, 1000.0}) {
        const double dt = ratio * ref::bond_time(chain);
        const TimeScheme scheme = ref::bonds_in_step(0.3);
        const auto marched = ref::step_modes(chain, scheme, motion, ends, dt);
        BOOST_REQUIRE(marched.size() == modes.size());
        std::vector<std::complex<double>> expected;
        for (const auto& mode : modes)
          expected.push_back(ref::step_root(scheme, mode.frequency * dt, tau * mode.frequency / 2));
        std::ranges::sort(expected, {}, [](std::complex<double> z) { return std::abs(std::log(z)); });
        for (std::size_t i = 0; i < modes.size(); ++i) {
          BOOST_TEST(std::abs(marched[i].z - expected[i]) < 1e-9, ratio << " t_b, mode " << i);
        }
      }
    }
  }
}

// The paper's dashpots couple the modes; their errors follow the law nevertheless.
BOOST_AUTO_TEST_CASE(period_and_damping_of_resolved_modes_follow_the_law) {
  for (const double xi : {0.02, 0.4}) {
    const auto chain = ref::with_bond_damping(undamped(13), xi);
    for (const auto ends : {ChainEnds::clamped_free, ChainEnds::free_free}) {
      for (const auto motion : {ChainMotion::bending, ChainMotion::axial, ChainMotion::twist}) {
        const auto modes = ref::chain_modes(chain, motion, ends);
        for (const TimeScheme& scheme : schemes) {
          const double dt = 0.06 / modes[0].frequency;
          if (dt > 0.2 * ref::bond_time(chain) && scheme.beta < 0.25) continue;  // not stable
          const auto marched = ref::step_modes(chain, scheme, motion, ends, dt);
          for (int i = 0; i < 3; ++i) {
            const double angle = modes[i].frequency * dt, zeta = modes[i].damping;
            if (angle > 0.4) continue;
            const ref::ModeError law = ref::error_law(scheme, angle, zeta);
            const double left_out =
                std::pow(angle, 4) / 5 + std::pow(angle, 3) * zeta + 4 * std::pow(angle * zeta, 2) + 1e-9;
            BOOST_TEST(std::abs(marched[i].frequency / modes[i].frequency - 1 - law.frequency) < left_out);
            BOOST_TEST(std::abs(marched[i].damping / zeta - 1 - law.damping) < left_out);
          }
        }
      }
    }
  }
}

// T/90: within 0.1 % for beta up to 0.327
BOOST_AUTO_TEST_CASE(damping_of_the_first_mode_at_a_ninetieth_of_its_period) {
  const auto chain = ref::with_bond_damping(undamped(13), 0.3);
  const auto first = ref::first_bending_mode(chain);
  const double dt = 2 * std::acos(-1.0) / 90 / first.frequency;
  const auto off = [&](double beta) {
    return ref::step_modes(chain, ref::bonds_in_step(beta), ChainMotion::bending, ChainEnds::clamped_free,
                           dt)[0]
                   .damping /
               first.damping -
           1;
  };
  BOOST_TEST(off(0.3) == -9.341e-4, boost::test_tools::tolerance(0.003));
  BOOST_TEST(off(0.326) > -0.001);
  BOOST_TEST(off(0.330) < -0.001);
}

BOOST_AUTO_TEST_CASE(the_largest_root_is_the_spectral_radius) {
  for (const double xi : {0.0, 0.4, 10.0}) {
    const auto chain = ref::with_bond_damping(undamped(9), xi);
    for (const auto motion : {ChainMotion::bending, ChainMotion::axial, ChainMotion::twist}) {
      for (const double ratio : {0.5, 30.0, 1000.0}) {
        const double dt = ratio * ref::bond_time(chain);
        double largest = 0;
        for (const auto& mode :
             ref::step_modes(chain, ref::bonds_in_step(0.3), motion, ChainEnds::clamped_free, dt))
          largest = std::max(largest, std::abs(mode.z));
        BOOST_TEST(
            largest == ref::chain_radius(chain, ref::bonds_in_step(0.3), motion, ChainEnds::clamped_free, dt),
            boost::test_tools::tolerance(1e-10));
      }
    }
  }
}

// A bond's steps in a longer chain: an undamped mode of infinite frequency turns by acos(1 - 1/(2 beta)).
BOOST_AUTO_TEST_CASE(unresolved_modes_crowd_at_the_angle_of_beta) {
  const auto chain = undamped(5);
  for (const double beta : {0.25, 0.3, 0.6}) {
    const auto modes = ref::step_modes(chain, ref::bonds_in_step(beta), ChainMotion::axial,
                                       ChainEnds::clamped_free, 1e5 * ref::bond_time(chain));
    for (const auto& mode : modes) {
      BOOST_TEST(std::abs(std::arg(mode.z) - std::acos(1 - 1 / (2 * beta))) < 1e-3);
      BOOST_TEST(std::abs(mode.damping) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const auto scheme = ref::bonds_in_step(0.3);
  BOOST_CHECK_THROW(ref::step_modes(undamped(101), scheme, ChainMotion::axial, ChainEnds::free_free, 1),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::step_modes(undamped(9), scheme, ChainMotion::axial, ChainEnds::free_free, -1),
                    ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
