// The polynomials of the inner loops against the exact functions, small matrices against Eigen, and the
// dashpots as a matrix against their forces.
#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "dem/bond/dashpot_matrix.hpp"
#include "dem/bond/kinematics.hpp"
#include "dem/math/near_one.hpp"

BOOST_AUTO_TEST_SUITE(math_test)

namespace dem = fiberchain::dem;

namespace {

constexpr double epsilon = 2.3e-16;

template <int N>
dem::Square<double, N> random_spd(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, N, N> B;
  for (double& b : B.reshaped()) b = normal(generator);
  const Eigen::Matrix<double, N, N> A = B * B.transpose() + Eigen::Matrix<double, N, N>::Identity();
  dem::Square<double, N> square;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) square[i][j] = A(i, j);
  }
  return square;
}

template <int N>
Eigen::Matrix<double, N, N> eigen(const dem::Square<double, N>& A) {
  return Eigen::Map<const Eigen::Matrix<double, N, N, Eigen::RowMajor>>(&A.c[0][0]);
}

template <int N>
void factors_solve() {
  std::mt19937 generator(7);
  for (int n = 0; n < 20; ++n) {
    const dem::Square<double, N> A = random_spd<N>(generator), B = random_spd<N>(generator);
    dem::Square<double, N> factors = A;
    dem::factorize(factors);
    const Eigen::Matrix<double, N, N> expected = eigen(A).ldlt().solve(eigen(B));
    BOOST_TEST((eigen(dem::solved(factors, B)) - expected).norm() < 1e-12 * expected.norm());
  }
}

/// Random velocities and spins of a bond's spheres.
template <int Dim>
void matrix_gives_the_dashpots_forces() {
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 20; ++n) {
    dem::BondParameters<double> bond{};
    bond.dash_stretch = 1.3, bond.dash_shear = 0.7, bond.dash_twist = 0.21, bond.dash_bend = 0.37;
    dem::Vec<double, Dim> r, v[2];
    dem::Spin<double, Dim> w[2];
    for (double& c : r.c) c = normal(generator);
    for (int k = 0; k < 2; ++k) {
      for (double& c : v[k].c) c = normal(generator);
      for (double& c : w[k].c) c = normal(generator);
    }
    const dem::Vec<double, Dim> e = (1 / dem::norm(r)) * r;
    const dem::RelativeMotion<double, Dim> motion{v[1] - v[0], 0.5 * (w[0] + w[1]), w[1] - w[0]};
    const auto loads = dem::act_at_middle(r, dem::dashpot_action(bond, r, e, motion));
    const auto C = dem::dashpot_matrix(bond, r, e);
    constexpr int N = dem::motions<Dim>;
    dem::Vec<double, N> x[2];
    for (int k = 0; k < 2; ++k) {
      for (int i = 0; i < N; ++i) x[k][i] = i < Dim ? v[k][i] : w[k][i - Dim];
    }
    const dem::Vec<double, N> first = C.first * x[0] + C.coupling * x[1];
    const dem::Vec<double, N> second = dem::transposed(C.coupling) * x[0] + C.second * x[1];
    for (int i = 0; i < Dim; ++i) {
      BOOST_TEST(std::abs(first[i] + loads.force_on_first[i]) < 1e-13);
      BOOST_TEST(std::abs(second[i] - loads.force_on_first[i]) < 1e-13);
    }
    for (int i = 0; i < dem::spin_size<Dim>; ++i) {
      BOOST_TEST(std::abs(first[Dim + i] + loads.moment_on_first[i]) < 1e-13);
      BOOST_TEST(std::abs(second[Dim + i] + loads.moment_on_second[i]) < 1e-13);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(inverse_square_root_is_exact_near_one_and_far_away) {
  for (double q = 0.5; q < 2; q += 1.7e-5)
    BOOST_REQUIRE(std::abs(dem::inverse_sqrt_near_one(q) * std::sqrt(q) - 1) < 3 * epsilon);
  for (const double q : {1e-30, 1e-3, 0.0, 7.0, 1e30})
    BOOST_TEST(dem::inverse_sqrt_near_one(q) == 1 / std::sqrt(q));
  BOOST_TEST(std::isnan(dem::inverse_sqrt_near_one(std::nan(""))));
}

BOOST_AUTO_TEST_CASE(series_below_one_leaves_out_the_fourth_order) {
  for (const double t : {-1e-2, -1e-3, 1e-3, 1e-2}) {
    const double left_out = 1 / std::sqrt(1 - t) - dem::inverse_sqrt_below_one(t);
    BOOST_TEST(std::abs(left_out / (35.0 / 128 * std::pow(t, 4)) - 1) < 0.02);
  }
}

BOOST_AUTO_TEST_CASE(arc_tangent_ratio_is_exact_near_zero_and_far_away) {
  for (double x = 1e-4; x < 3; x += 1.3e-4) {
    BOOST_REQUIRE(std::abs(dem::atan_ratio(x * x) * x / std::atan(x) - 1) < 4 * epsilon);
  }
  BOOST_TEST(dem::atan_ratio(0.0) == 1);
}

BOOST_AUTO_TEST_CASE(factors_of_symmetric_matrices_solve) {
  factors_solve<3>();
  factors_solve<6>();
}

BOOST_AUTO_TEST_CASE(inverse_by_the_adjugate) {
  std::mt19937 generator(5);
  for (int n = 0; n < 20; ++n) {
    const auto A = random_spd<3>(generator);
    BOOST_TEST((eigen(A) * eigen(dem::inverse(A)) - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_dashpots_matrix_gives_their_forces) {
  matrix_gives_the_dashpots_forces<2>();
  matrix_gives_the_dashpots_forces<3>();
}

BOOST_AUTO_TEST_SUITE_END()
