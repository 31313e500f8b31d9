// The largest stable step of the endless chain: the numbers found before, and the roots of the scheme itself.
#include "reference/stable_step.hpp"

#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(stable_step_test)

namespace ref = fiberchain::reference;

namespace {

ref::LinearChain chain_of(double nu, double xi) {
  return ref::with_bond_damping(ref::linear_chain({10, 1.7e-3, 3.1e6, nu, 870}), xi);
}

/// Largest |z| over all bending waves of x' = x + dt v', v' = v - dt M^-1 (K x + C v): the scheme applied to
/// its own unknowns, two displacements and two velocities per wave.
double bending_growth(const ref::LinearChain& chain, double dt) {
  using Matrix = Eigen::MatrixXcd;
  const std::complex<double> i(0, 1);
  double largest = 0;
  for (int wave = 0; wave <= 400; ++wave) {
    const double half = std::numbers::pi * wave / 800;
    Eigen::RowVector2cd shear, bend;
    shear << 2.0 * i * std::sin(half), -chain.spacing * std::cos(half);
    bend << 0.0, 2.0 * i * std::sin(half);
    const auto form = [&](double s, double b) -> Matrix {
      return s * shear.adjoint() * shear + b * bend.adjoint() * bend;
    };
    Matrix weight = Matrix::Zero(2, 2);
    weight(0, 0) = 1 / chain.mass;
    weight(1, 1) = 1 / chain.inertia;
    const Matrix k = weight * form(chain.stiffness.shear, chain.stiffness.bend);
    const Matrix c = weight * form(chain.dashpot.shear, chain.dashpot.bend);
    const Matrix one = Matrix::Identity(2, 2);
    Matrix step(4, 4);
    step << one - dt * dt * k, dt * (one - dt * c), -dt * k, one - dt * c;
    // lengths in spacings, times in steps: only the eigenvalues count
    largest =
        std::max(largest, Eigen::ComplexEigenSolver<Matrix>(step, false).eigenvalues().cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(known_limits_at_poisson_s_ratio_0_3) {
  constexpr double damping[] = {0, 0.1, 0.25, 0.5, 1, 2, 5};
  constexpr double limit[] = {1.00, 0.82, 0.60, 0.39, 0.218, 0.113, 0.046};
  for (int i = 0; i < 7; ++i) {
    const auto chain = chain_of(0.3, damping[i]);
    const double found = ref::largest_stable_step(chain) / ref::bond_time(chain);
    BOOST_TEST(std::abs(found - limit[i]) < (limit[i] < 0.3 ? 0.0006 : 0.006),
               "xi_b " << damping[i] << ": " << found);
  }
}

BOOST_AUTO_TEST_CASE(undamped_limit_is_rotation_below_nu_0_25_and_stretch_above) {
  const auto limit = [](double nu) {
    const auto chain = chain_of(nu, 0);
    return ref::largest_stable_step(chain) / ref::bond_time(chain);
  };
  for (const double nu : {-0.7, -0.2, 0.0, 0.17, 0.3, 0.41}) {
    BOOST_TEST(limit(nu) == std::min(1.0, std::sqrt(0.8 * (1 + nu))), boost::test_tools::tolerance(1e-12));
  }
  // where the two meet, long bending waves are a little stricter than either
  BOOST_TEST(limit(0.25) < 1 - 1e-4);
  BOOST_TEST(limit(0.25) > 1 - 4e-4);
}

BOOST_AUTO_TEST_CASE(the_scheme_grows_just_above_and_not_just_below) {
  for (const double nu : {-0.3, 0.1, 0.25}) {
    for (const double xi : {0.0, 0.2, 1.3}) {
      ref::LinearChain chain = chain_of(nu, xi);
      chain.stiffness.stretch *= 1e-3;  // leave bending waves alone to decide
      chain.dashpot.stretch *= 1e-3;
      const double limit = ref::largest_stable_step(chain, true);
      BOOST_TEST(bending_growth(chain, 0.999 * limit) < 1 + 1e-7, "nu " << nu << " xi_b " << xi);
      BOOST_TEST(bending_growth(chain, 1.001 * limit) > 1 + 1e-4, "nu " << nu << " xi_b " << xi);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_corrected_bond_and_planar_motion_have_their_own_limits) {
  ref::LinearChain corrected = chain_of(0.3, 0);
  const double paper = ref::largest_stable_step(corrected);
  corrected.stiffness.shear = 0.75 * corrected.stiffness.stretch;
  // rotation decides: dt^2 K_t l^2 / 4 = J
  BOOST_TEST(ref::largest_stable_step(corrected) == paper * std::sqrt(0.4 / 0.75),
             boost::test_tools::tolerance(1e-12));
  ref::LinearChain twisting = chain_of(0.3, 0);
  twisting.stiffness.twist *= 100;
  BOOST_TEST(ref::largest_stable_step(twisting, true) == paper);
  BOOST_TEST(ref::largest_stable_step(twisting, false) < 0.5 * paper);
}

BOOST_AUTO_TEST_CASE(a_broken_chain_is_refused) {
  ref::LinearChain chain = chain_of(0.3, 1);
  chain.dashpot.bend = -1;
  BOOST_CHECK_THROW(ref::largest_stable_step(chain), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
