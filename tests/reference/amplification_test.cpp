// The spectral radius of one step of each scheme, by three routes: waves of an endless chain, the
// dense matrix of a finite one, and the pencil whose definiteness tells the same in linear time.
#include "reference/amplification.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/errors.hpp"
#include "reference/stable_step.hpp"

BOOST_AUTO_TEST_SUITE(amplification_test)

namespace ref = fiberchain::reference;
using ref::ChainEnds;
using ref::ChainMotion;
using ref::TimeScheme;
using std::numbers::pi;

namespace {

constexpr TimeScheme schemes[] = {ref::lagged_dashpots, ref::damped_in_step};
constexpr ChainMotion motions[] = {ChainMotion::bending, ChainMotion::axial, ChainMotion::twist};
constexpr ChainEnds all_ends[] = {ChainEnds::clamped_free, ChainEnds::free_free};

ref::LinearChain chain_of(int bonds, double nu, double xi) {
  return ref::with_bond_damping(ref::linear_chain({bonds, 1.7e-3, 3.1e6, nu, 870}), xi);
}

double largest_chain_radius(const ref::LinearChain& chain, const TimeScheme& scheme, ChainEnds ends,
                            double dt) {
  double largest = 0;
  for (const auto motion : motions) {
    largest = std::max(largest, ref::chain_radius(chain, scheme, motion, ends, dt));
  }
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(undamped_waves_stay_on_the_unit_circle_to_round_off) {
  const auto chain = chain_of(9, 0.17, 0);
  for (const auto scheme : schemes) {
    for (const auto motion : motions) {
      for (int i = 0; i <= 20; ++i) {
        const double radius =
            ref::wave_radius(chain, scheme, motion, pi * i / 20, 0.9 * ref::bond_time(chain));
        BOOST_TEST(std::abs(radius - 1) < 1e-12, "phase " << i << ": " << radius - 1);
      }
    }
  }
}

// m (z-1)^2 + c dt (z-1) + k dt^2 z = 0 with the axial wave's m, c, k: its roots by the formula for
// quadratics.
BOOST_AUTO_TEST_CASE(an_axial_wave_has_the_roots_of_its_quadratic) {
  const auto chain = chain_of(9, 0.3, 0.4);
  const double factor = 4 * std::pow(std::sin(1.1 / 2), 2), m = chain.mass;
  const double c = factor * chain.dashpot.stretch, k = factor * chain.stiffness.stretch;
  for (const double ratio : {0.2, 0.5, 1.1}) {
    const double dt = ratio * ref::bond_time(chain);
    for (const auto scheme : schemes) {
      const bool lagged = scheme.theta == 0;
      const double a = lagged ? m : m + c * dt / 2, b = -2 * m + k * dt * dt + (lagged ? c * dt : 0);
      const double last = lagged ? m - c * dt : m - c * dt / 2, square = b * b - 4 * a * last;
      const double expected = square < 0 ? std::sqrt(last / a) : (std::abs(b) + std::sqrt(square)) / (2 * a);
      BOOST_TEST(ref::wave_radius(chain, scheme, ChainMotion::axial, 1.1, dt) == expected,
                 boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(endless_chains_limit_is_that_of_positive_definiteness) {
  for (const double nu : {-0.2, 0.0, 0.17, 0.24, 0.3, 0.49}) {
    for (const double xi : {0.0, 0.03, 0.6, 10.0}) {
      for (const bool planar : {false, true}) {
        const auto chain = chain_of(9, nu, xi);
        const double definite = ref::largest_stable_step(chain, planar);
        const double spectral = ref::endless_stable_step(chain, ref::lagged_dashpots, planar);
        BOOST_TEST(std::abs(spectral / definite - 1) < 1e-6,
                   "nu " << nu << " xi_b " << xi << ": " << spectral / definite - 1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(dashpots_solved_within_the_step_do_not_change_the_limit) {
  for (const double nu : {-0.2, 0.24, 0.43}) {
    const double undamped = ref::largest_stable_step(chain_of(9, nu, 0));
    for (const double xi : {0.0, 0.7, 10.0, 1000.0}) {
      const double limit = ref::endless_stable_step(chain_of(9, nu, xi), ref::damped_in_step);
      BOOST_TEST(std::abs(limit / undamped - 1) < 1e-6,
                 "nu " << nu << " xi_b " << xi << ": " << limit / undamped - 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(finite_chains_leave_the_unit_circle_where_their_pencil_says) {
  for (const auto scheme : schemes) {
    for (const auto ends : all_ends) {
      for (const double xi : {0.0, 0.2, 3.0}) {
        for (const auto& [bonds, nu] : {std::pair{1, 0.3}, {5, -0.15}, {12, 0.41}}) {
          const auto chain = chain_of(bonds, nu, xi);
          const double limit = ref::finite_stable_step(chain, scheme, ends);
          BOOST_TEST(largest_chain_radius(chain, scheme, ends, limit * (1 - 1e-6)) < 1 + 1e-10);
          BOOST_TEST(largest_chain_radius(chain, scheme, ends, limit * (1 + 1e-6)) > 1 + 1e-7);
          const double dense = largest_chain_radius(chain, scheme, ends, 1.3 * limit);
          BOOST_TEST(ref::growth_per_step(chain, scheme, ends, 1.3 * limit) == dense,
                     boost::test_tools::tolerance(1e-9));
          BOOST_TEST(ref::growth_per_step(chain, scheme, ends, 0.999 * limit) == 1);
        }
      }
    }
  }
}

// A wave of frequency w: dt w = 1/sqrt(1/4 - beta).
BOOST_AUTO_TEST_CASE(a_part_of_the_stiffness_in_the_matrix_lengthens_the_undamped_limit) {
  const auto chain = chain_of(9, -0.15, 0);
  const double explicit_step = ref::endless_stable_step(chain, ref::damped_in_step);
  const double finite_step = ref::finite_stable_step(chain, ref::damped_in_step, ChainEnds::free_free);
  for (const double beta : {0.03, 0.17, 0.2499}) {
    const TimeScheme scheme = ref::bonds_in_step(beta);
    const double longer = std::sqrt(0.25 / (0.25 - beta));
    for (const double xi : {0.0, 3.0}) {
      const auto damped = chain_of(9, -0.15, xi);
      BOOST_TEST(std::abs(ref::endless_stable_step(damped, scheme) / (longer * explicit_step) - 1) < 1e-6);
      BOOST_TEST(
          std::abs(ref::finite_stable_step(damped, scheme, ChainEnds::free_free) / (longer * finite_step) -
                   1) < 1e-11);
    }
    const double dt = 1.2 * longer * finite_step;
    const double dense = largest_chain_radius(chain, scheme, ChainEnds::free_free, dt);
    BOOST_TEST(dense > 1.01);
    BOOST_TEST(ref::growth_per_step(chain, scheme, ChainEnds::free_free, dt) == dense,
               boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(from_beta_one_quarter_on_no_step_lets_a_motion_grow) {
  for (const double beta : {0.25, 0.3}) {
    const TimeScheme scheme = ref::bonds_in_step(beta);
    for (const auto& [nu, xi] : {std::pair{-0.2, 0.0}, {0.49, 0.1}, {0.17, 1.0}, {0.3, 10.0}}) {
      const auto chain = chain_of(13, nu, xi);
      BOOST_TEST(std::isinf(ref::endless_stable_step(chain, scheme)));
      BOOST_TEST(std::isinf(ref::finite_stable_step(chain, scheme, ChainEnds::clamped_free)));
      for (const double ratio : {0.3, 10.0, 100.0, 1000.0}) {
        const double dt = ratio * ref::bond_time(chain);
        BOOST_TEST(ref::growth_per_step(chain, scheme, ChainEnds::clamped_free, dt) == 1);
        for (const auto motion : motions) {
          for (int i = 0; i <= 10; ++i) {
            const double radius = ref::wave_radius(chain, scheme, motion, pi * i / 10, dt);
            BOOST_TEST(radius < 1 + 1e-11, "phase " << i << ": " << radius - 1);
            if (xi == 0) BOOST_TEST(radius > 1 - 1e-11);
          }
          const double held = ref::chain_radius(chain, scheme, motion, ChainEnds::clamped_free, dt);
          if (xi == 0) BOOST_TEST(std::abs(held - 1) < 1e-11);
          if (xi > 0) BOOST_TEST(held < 1 - 1e-7);
        }
      }
    }
  }
}

// The last axial mode of the free chain alone: dt = t_b/sin(n pi/(2n + 2)), stretch being what decides at nu
// = 0.45.
BOOST_AUTO_TEST_CASE(undamped_limit_of_a_finite_chain_is_its_stiffest_mode) {
  for (const int bonds : {5, 8, 40}) {
    const auto chain = chain_of(bonds, 0.45, 0);
    const double limit = ref::finite_stable_step(chain, ref::lagged_dashpots, ChainEnds::free_free);
    BOOST_TEST(limit == ref::bond_time(chain) / std::sin(bonds * pi / (2.0 * bonds + 2)),
               boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(limits_of_longer_chains_fall_toward_the_endless_one) {
  for (const auto ends : all_ends) {
    for (const double xi : {0.0, 1.0}) {
      double before = 1e300;
      for (const int bonds : {3, 9, 27, 81, 2000}) {
        const auto chain = chain_of(bonds, 0.1, xi);
        const double endless = ref::largest_stable_step(chain);
        const double over = ref::finite_stable_step(chain, ref::lagged_dashpots, ends) / endless - 1;
        BOOST_TEST(over > -1e-12);
        BOOST_TEST(over < before);
        if (bonds == 2000) BOOST_TEST(over < 1e-5);
        before = over + 1e-13;
      }
    }
  }
}

// t_b/T_R = sqrt(8/3 G/E) (0.1631 nu + 0.8766) 2/pi, E/G = 2(1 + nu), from sqrt(m/K_n) = sqrt(8/3) R
// sqrt(rho/E)
BOOST_AUTO_TEST_CASE(bond_time_over_the_rayleigh_step) {
  for (const double nu : {-0.2, 0.0, 0.3, 0.5}) {
    const ref::ChainMaterial material{7, 0.4e-3, 2.2e9, nu, 1300};
    const double ratio = ref::bond_time(ref::linear_chain(material)) / ref::rayleigh_step(material);
    BOOST_TEST(ratio == std::sqrt(8.0 / 3 / (2 * (1 + nu))) * (0.1631 * nu + 0.8766) / pi,
               boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const auto chain = chain_of(9, 0.3, 1);
  const TimeScheme lagged = ref::lagged_dashpots;
  BOOST_CHECK_THROW(ref::wave_radius(chain, lagged, ChainMotion::axial, 4, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::growth_per_step(chain, lagged, ChainEnds::free_free, 0), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::wave_radius(chain, {0.6, 0}, ChainMotion::axial, 1, 1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::wave_radius(chain, lagged, ChainMotion::bending, 1, 1, -1), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::finite_stable_step(chain, ref::bonds_in_step(1.1), ChainEnds::free_free),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(
      ref::chain_radius(chain_of(201, 0.3, 1), lagged, ChainMotion::axial, ChainEnds::free_free, 1),
      ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::rayleigh_step({7, -1, 1, 0.3, 1}), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
