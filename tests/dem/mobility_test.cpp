// Hydrodynamic interactions of two and more spheres: against averages over both spheres' surfaces taken by
// quadrature, which share nothing with the closed forms but the field of a point force.
#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "dem/flow/mobility.hpp"
#include "dem/flow/pair_mobility.hpp"
#include "dem/model/errors.hpp"

BOOST_AUTO_TEST_SUITE(mobility_test)

namespace dem = fiberchain::dem;
namespace pair = fiberchain::dem::pair;

namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

struct Node {
  Vector normal;
  double weight;  ///< of the mean over the sphere
};

/// Product rule on the unit sphere: Gauss-Legendre in z by Golub and Welsch, equal steps about it.
std::vector<Node> sphere_rule(int n) {
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(n, n);
  for (int i = 1; i < n; ++i) T(i, i - 1) = T(i - 1, i) = i / std::sqrt(4.0 * i * i - 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gauss(T);
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    const double z = gauss.eigenvalues()[i], w = std::pow(gauss.eigenvectors()(0, i), 2),
                 s = std::sqrt(1 - z * z);
    for (int k = 0; k < 2 * n; ++k) {
      const double phi = std::numbers::pi * (k + 0.37) / n;
      nodes.push_back({{s * std::cos(phi), s * std::sin(phi), z}, w / (2 * n)});
    }
  }
  return nodes;
}

/// Velocity of a point force, in units of 1 / (8 pi mu).
Vector point_force_field(const Vector& r, const Vector& force) {
  const double d = r.norm();
  return force / d + r * (r.dot(force) / (d * d * d));
}

struct Motion {
  Vector velocity = Vector::Zero(), spin = Vector::Zero();
  Matrix strain = Matrix::Zero();
};

/// Means over the surface of unit sphere i of what a force F, torque T and dipole S spread over unit sphere j
/// do.
Motion by_quadrature(const Vector& between, const Vector& F, const Vector& T, const Matrix& S) {
  static const std::vector<Node> rule = sphere_rule(24);
  Motion mean;
  for (const Node& i : rule) {
    Vector u = Vector::Zero();
    for (const Node& j : rule) {
      const Vector push = F + 1.5 * T.cross(j.normal) + 3 * (S * j.normal);
      u += j.weight * point_force_field(between + i.normal - j.normal, push);
    }
    mean.velocity += i.weight * u;
    mean.spin += i.weight * 1.5 * i.normal.cross(u);
    mean.strain += i.weight * 1.5 * (u * i.normal.transpose() + i.normal * u.transpose());
  }
  mean.strain -= mean.strain.trace() / 3 * Matrix::Identity();
  return mean;
}

const Vector kBetween{1.31, -1.57, 1.09};  // 2.32 R apart
const Vector kForce{0.7, -1.3, 0.4}, kTorque{-0.9, 0.3, 1.1};

Matrix some_dipole() {
  Matrix S;
  S << 0.4, -0.7, 0.3, -0.7, 0.5, 1.2, 0.3, 1.2, -0.9;
  return S;
}

dem::Fluid fluid(dem::Hydrodynamics hydrodynamics) { return {0.83, {dem::simple_shear(1.7)}, hydrodynamics}; }

dem::Poses<3> bent_line(int n, double radius) {
  dem::Poses<3> poses(n);
  for (int i = 0; i < n; ++i) {
    const double s = 2.02 * radius * i;
    poses[i] = {{s, 0.03 * s * s / radius, -0.02 * s * s / radius}, {1, {0, 0, 0}}};
  }
  return poses;
}

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_are_means_over_both_surfaces) {
  const pair::Line l{kBetween.norm(), kBetween.normalized()};
  const Matrix S = some_dipole();
  const Motion of_force = by_quadrature(kBetween, kForce, Vector::Zero(), Matrix::Zero());
  const Motion of_torque = by_quadrature(kBetween, Vector::Zero(), kTorque, Matrix::Zero());
  const Motion of_dipole = by_quadrature(kBetween, Vector::Zero(), Vector::Zero(), S);
  // the rule is good to 5e-9 for spheres this far apart
  BOOST_TEST((pair::translation_by_force(l) * kForce - of_force.velocity).norm() < 1e-7);
  BOOST_TEST((pair::translation_by_torque(l) * kForce - of_force.spin).norm() < 1e-7);
  BOOST_TEST((pair::translation_by_torque(l) * kTorque - of_torque.velocity).norm() < 1e-7);
  BOOST_TEST((pair::spin_by_torque(l) * kTorque - of_torque.spin).norm() < 1e-7);
  BOOST_TEST((pair::translation_by_dipole(l, S) - of_dipole.velocity).norm() < 1e-7);
  BOOST_TEST((pair::spin_by_dipole(l, S) - of_dipole.spin).norm() < 1e-7);
  BOOST_TEST((pair::strain_by_dipole(l, S) - of_dipole.strain).norm() < 1e-7);
  BOOST_TEST(of_force.velocity.norm() > 0.1);
  BOOST_TEST(of_dipole.strain.norm() > 0.01);
}

BOOST_AUTO_TEST_CASE(strain_by_force_and_torque_mirror_what_a_dipole_does) {
  const pair::Line l{kBetween.norm(), kBetween.normalized()};
  const Matrix S = some_dipole();
  // reciprocity: S at j moves i as force and torque at i strain j, seen from the other side
  const Motion of_force = by_quadrature(-kBetween, kForce, Vector::Zero(), Matrix::Zero());
  const Motion of_torque = by_quadrature(-kBetween, Vector::Zero(), kTorque, Matrix::Zero());
  BOOST_TEST(pair::translation_by_dipole(l, S).dot(kForce) == of_force.strain.cwiseProduct(S).sum(),
             boost::test_tools::tolerance(1e-7));
  BOOST_TEST(pair::spin_by_dipole(l, S).dot(kTorque) == of_torque.strain.cwiseProduct(S).sum(),
             boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(overlapping_spheres_join_on_smoothly) {
  const Vector e = kBetween.normalized();
  const pair::Line outside{2, e}, inside{2 - 1e-12, e}, same{1e-9, e};
  BOOST_TEST((pair::translation_by_force(outside) - pair::translation_by_force(inside)).norm() < 1e-11);
  BOOST_TEST((pair::translation_by_torque(outside) - pair::translation_by_torque(inside)).norm() < 1e-11);
  BOOST_TEST((pair::spin_by_torque(outside) - pair::spin_by_torque(inside)).norm() < 1e-11);
  BOOST_TEST((pair::translation_by_force(same) - pair::own_translation * Matrix::Identity()).norm() < 1e-8);
  BOOST_TEST((pair::spin_by_torque(same) - pair::own_spin * Matrix::Identity()).norm() < 1e-8);
}

BOOST_AUTO_TEST_CASE(mobility_is_symmetric_and_positive) {
  const double R = 0.0131;
  for (const auto hydrodynamics : {dem::Hydrodynamics::interactions, dem::Hydrodynamics::stresslets}) {
    const dem::Mobility m = dem::mobility<3>(fluid(hydrodynamics), R, bent_line(7, R));
    BOOST_TEST((m.motion - m.motion.transpose()).norm() < 1e-14 * m.motion.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(m.motion);
    BOOST_TEST(eigen.eigenvalues().minCoeff() > 0);
  }
}

/// Far apart every sphere is alone: Stokes' drag.
BOOST_AUTO_TEST_CASE(far_apart_is_free_draining) {
  const double R = 0.0131, far = 1e9 * R;
  dem::Poses<3> poses(2);
  poses[0] = {{0, 0, 0}, {1, {0, 0, 0}}};
  poses[1] = {{0.6 * far, -0.8 * far, 0}, {1, {0, 0, 0}}};
  const dem::Mobility m = dem::mobility<3>(fluid(dem::Hydrodynamics::stresslets), R, poses);
  const double mu = 0.83, pi = std::numbers::pi;
  for (int i = 0; i < 12; ++i) {
    const double alone = i % 6 < 3 ? 1 / (6 * pi * mu * R) : 1 / (8 * pi * mu * R * R * R);
    BOOST_TEST(m.motion(i, i) == alone, boost::test_tools::tolerance(1e-8));
    for (int k = 0; k < i; ++k)
      BOOST_TEST(std::abs(m.motion(i, k)) < 2e-9 * std::sqrt(m.motion(i, i) * m.motion(k, k)));
  }
  BOOST_TEST(m.strain.cwiseAbs().maxCoeff() < 1e-8);
}

BOOST_AUTO_TEST_CASE(plane_is_the_plane_of_space) {
  const double R = 0.0131;
  dem::Poses<3> space = bent_line(5, R);
  dem::Poses<2> plane(5);
  for (int i = 0; i < 5; ++i) {
    space[i].position[2] = 0;
    plane[i] = {{space[i].position[0], space[i].position[1]}, 0.1};
  }
  const dem::Fluid with = fluid(dem::Hydrodynamics::stresslets);
  const dem::Mobility a = dem::mobility<3>(with, R, space), b = dem::mobility<2>(with, R, plane);
  const int kept[] = {0, 1, 5};
  for (int i = 0; i < 15; ++i) {
    for (int k = 0; k < 15; ++k) {
      BOOST_TEST(std::abs(b.motion(i, k) - a.motion(i / 3 * 6 + kept[i % 3], k / 3 * 6 + kept[k % 3])) <
                 1e-14 * a.motion.cwiseAbs().maxCoeff());
    }
  }
  BOOST_TEST((a.strain.row(6 + 5) - b.strain.row(3 + 2)).norm() < 1e-14);
}

BOOST_AUTO_TEST_CASE(overlap_with_stresslets_is_refused) {
  const double R = 0.0131;
  dem::Poses<2> poses(2);
  poses[0] = {{0, 0}, 0.0};
  poses[1] = {{1.7 * R, 0}, 0.0};
  BOOST_CHECK_THROW(dem::mobility<2>(fluid(dem::Hydrodynamics::stresslets), R, poses), dem::Diverged);
  BOOST_CHECK_NO_THROW(dem::mobility<2>(fluid(dem::Hydrodynamics::interactions), R, poses));
}

BOOST_AUTO_TEST_SUITE_END()
