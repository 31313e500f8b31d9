// Equilibria beyond a critical load: pivots against dense eigenvalues, buckled columns against the Elastica's
// closed form
//   P L^2 / (E I) = K(k)^2, y / L = 2 k / K, x / L = 2 E / K - 1, k = sin(alpha / 2), alpha the tip's angle
// (Timoshenko & Gere, Theory of Elastic Stability, 2.7), and the path that a load slightly across takes.
#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/equilibrium/newton.hpp"
#include "dem/model/errors.hpp"
#include "dem/run/run_fiber.hpp"

BOOST_AUTO_TEST_SUITE(equilibrium_stability_test)

namespace dem = fiberchain::dem;

namespace {

dem::Fiber fiber(int bonds, double poisson_ratio = 0.17) {
  return {dem::isotropic_material(3.1e6, poisson_ratio, 1300), 1.3e-3, bonds, dem::BondModel::corrected};
}

/// Pushed along the axis by a load P L^2 / (E I) at an angle [rad] to it.
template <int Dim>
dem::Boundary<Dim> pushed(const dem::Fiber& fiber, double load, double angle) {
  dem::Vec<double, Dim> force{};
  force[0] = -dem::load_force(fiber, load) * std::cos(angle);
  force[1] = dem::load_force(fiber, load) * std::sin(angle);
  return {{0}, {{fiber.aspect_ratio, force, {}}}};
}

struct Tip {
  double x, y;  ///< over L
};

template <int Dim>
Tip tip(const dem::Equilibrium<Dim>& found, const dem::Fiber& fiber) {
  const auto& position = found.poses.back().position;
  return {position[0] / dem::fiber_length(fiber), position[1] / dem::fiber_length(fiber)};
}

Tip elastica(double load) {
  double low = 0, high = 1 - 1e-12;
  for (int n = 0; n < 200; ++n) {
    const double k = 0.5 * (low + high);
    (std::pow(std::comp_ellint_1(k), 2) < load ? low : high) = k;
  }
  const double K = std::comp_ellint_1(low);
  return {2 * std::comp_ellint_2(low) / K - 1, 2 * low / K};
}

/// Eigenvalues of K v = lambda (E I / L) W v by a dense solver, spheres that are not clamped only.
Eigen::VectorXd dense_eigenvalues(const dem::Chain<2>& chain, const dem::Poses<2>& poses,
                                  const dem::Boundary<2>& boundary) {
  const dem::ChainTangent<2> K = dem::stiffness(chain, poses, boundary);
  const int n = K.blocks() - 1;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3 * n, 3 * n), W = A;
  const double L = dem::fiber_length(chain.fiber), unit = dem::bending_stiffness(chain.fiber) / L;
  for (int i = 0; i < n; ++i) {
    A.block<3, 3>(3 * i, 3 * i) = K.diagonal[i + 1];
    if (i > 0) A.block<3, 3>(3 * i, 3 * i - 3) = K.lower[i + 1];
    if (i + 1 < n) A.block<3, 3>(3 * i, 3 * i + 3) = K.upper[i + 1];
    W.diagonal().segment<3>(3 * i) << unit / (L * L), unit / (L * L), unit;
  }
  BOOST_TEST((A - A.transpose()).norm() < 1e-9 * A.norm());
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(A, W, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

constexpr double kEuler = 2.4674011002723395;  // pi^2 / 4

}  // namespace

BOOST_AUTO_TEST_CASE(pivots_count_the_eigenvalues_of_a_dense_solver) {
  const dem::Fiber f = fiber(13);
  const dem::Chain<2> chain = dem::straight_chain<2>(f);
  for (const double load : {1.0, 5.0, 30.0, 90.0}) {
    const dem::Boundary<2> boundary = pushed<2>(f, load, 0);
    const dem::Equilibrium<2> straight = dem::solve_equilibrium(chain, boundary, {.allow_unstable = true});
    const Eigen::VectorXd dense = dense_eigenvalues(chain, straight.poses, boundary);
    const dem::ChainTangent<2> K = dem::stiffness(chain, straight.poses, boundary);
    for (const int k : {0, 1, 5, 20}) {
      BOOST_TEST(dem::eigenvalues_below(chain, K, boundary, dense(k) - 1e-6 * std::abs(dense(k))) == k);
      BOOST_TEST(dem::eigenvalues_below(chain, K, boundary, dense(k) + 1e-6 * std::abs(dense(k))) == k + 1);
    }
    BOOST_CHECK_CLOSE_FRACTION(dem::lowest_mode(chain, straight.poses, boundary).eigenvalue, dense(0), 1e-5);
    BOOST_TEST((straight.stability == dem::Stability::unstable) == (load > kEuler));
  }
}

BOOST_AUTO_TEST_CASE(a_straight_column_is_stable_up_to_eulers_load) {
  // the chain's own critical load meets Euler's at second order in 1/r_f
  double previous = 0;
  for (const int bonds : {13, 26, 52}) {
    const dem::Fiber f = fiber(bonds);
    const dem::Chain<2> chain = dem::straight_chain<2>(f);
    double low = 2, high = 3;
    while (high - low > 1e-9) {
      const double load = 0.5 * (low + high);
      const auto straight = dem::solve_equilibrium(chain, pushed<2>(f, load, 0), {.allow_unstable = true});
      (straight.stability == dem::Stability::unstable ? high : low) = load;
    }
    const double error = low / kEuler - 1;
    if (previous != 0) BOOST_TEST(std::abs(std::log2(previous / error) - 2) < 0.1);
    BOOST_TEST(std::abs(error) < 0.5 / (bonds * bonds));
    previous = error;
  }
}

BOOST_AUTO_TEST_CASE(a_buckled_column_stands_as_the_elastica) {
  for (const double load : {2.6, 2.84171, 5.0, 22.2}) {
    const Tip exact = elastica(load);
    double previous = 0;
    for (const int bonds : {40, 80}) {
      const dem::Fiber f = fiber(bonds);
      const auto found = dem::solve_equilibrium(dem::straight_chain<2>(f), pushed<2>(f, load, 0));
      BOOST_TEST((found.stability == dem::Stability::stable));
      BOOST_TEST(found.statistics.bucklings > 0);
      const Tip t = tip(found, f);
      const double error = std::hypot(t.x - exact.x, t.y - exact.y);
      BOOST_TEST(error < 2.5 / (bonds * bonds),
                 "at load " << load << ": " << error);  // the stretch of its bonds
      if (previous != 0) BOOST_TEST(std::abs(std::log2(previous / error) - 2) < 0.1);
      previous = error;
    }
  }
}

BOOST_AUTO_TEST_CASE(a_push_slightly_across_bends_its_way) {
  const dem::Fiber f = fiber(40, 0.3);
  for (const double angle : {0.2, 1e-2, -1e-3, 1e-5, -1e-7}) {
    for (const double load : {2.6, 5.0, 12.0}) {
      const auto flat = dem::solve_equilibrium(dem::straight_chain<2>(f), pushed<2>(f, load, angle));
      const auto spatial = dem::solve_equilibrium(dem::straight_chain<3>(f), pushed<3>(f, load, angle));
      BOOST_TEST((flat.stability == dem::Stability::stable));
      BOOST_TEST((spatial.stability == dem::Stability::stable || std::abs(angle) < 1e-4),
                 "in space, load " << load << " at " << angle << ": " << dem::name(spatial.stability));
      const Tip t = tip(flat, f), s = tip(spatial, f);
      BOOST_TEST(t.y * angle > 0, "load " << load << " at " << angle << " ends at y/L = " << t.y);
      if (std::abs(angle) > 1e-4) BOOST_TEST(std::hypot(t.x - s.x, t.y - s.y) < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_column_in_space_may_buckle_to_any_side) {
  const dem::Fiber f = fiber(20);
  const auto found = dem::solve_equilibrium(dem::straight_chain<3>(f), pushed<3>(f, 4, 0));
  BOOST_TEST((found.stability == dem::Stability::neutral));
  BOOST_TEST(tip(found, f).y > 0.5);
  BOOST_TEST(std::abs(found.residual.moment) < 1e-10);
}

BOOST_AUTO_TEST_CASE(moments_in_space_have_no_potential) {
  const dem::Fiber f = fiber(8);
  const auto found =
      dem::solve_equilibrium(dem::straight_chain<3>(f), dem::Boundary<3>{{0}, {{8, {}, {0, 1e-6, 0}}}});
  BOOST_TEST((found.stability == dem::Stability::undecided));
}

namespace {

dem::CantileverScene scene_of(int bonds, double load, std::array<double, 3> direction) {
  const double size = std::hypot(direction[0], direction[1], direction[2]);
  for (double& part : direction) part /= size;
  dem::CantileverScene scene{.fiber = fiber(bonds, 0.3), .load = load};
  scene.direction = direction;
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_solved_scene_bends_with_its_load_and_says_that_it_is_stable) {
  const dem::CantileverScene scene = scene_of(80, 5, {-1, 0.2, 0});
  const auto rest = dem::find_rest<2>(scene);
  // The other branch ends at -0.3049, against the load. Value of an independent shooting of the Elastica,
  // which this chain's stretch and shear leave by 2e-4.
  BOOST_TEST(std::abs(rest.poses.back().position[1] / dem::fiber_length(scene.fiber) - 0.8092) < 5e-4);
  BOOST_TEST((rest.stability == dem::Stability::stable));
}

BOOST_AUTO_TEST_CASE(an_unstable_equilibrium_is_an_answer_only_when_asked_for) {
  dem::CantileverScene scene = scene_of(12, 9 * kEuler, {-1, 0, 0});
  BOOST_TEST((dem::find_rest<2>(scene).stability == dem::Stability::stable));
  scene.method = dem::Method::march;  // nothing disturbs the straight fiber
  BOOST_CHECK_THROW(dem::find_rest<2>(scene), dem::NoConvergence);
  scene.allow_unstable = true;
  BOOST_TEST((dem::find_rest<2>(scene).stability == dem::Stability::unstable));
  scene.method = dem::Method::solve;
  const auto straight = dem::find_rest<2>(scene);
  BOOST_TEST((straight.stability == dem::Stability::unstable));
  BOOST_TEST(std::abs(straight.poses.back().position[1]) < 1e-12 * dem::fiber_length(scene.fiber));
}

BOOST_AUTO_TEST_SUITE_END()
