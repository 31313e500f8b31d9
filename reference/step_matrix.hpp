#pragma once

#include <Eigen/Dense>

#include "reference/time_scheme.hpp"

namespace fiberchain::reference::detail {

/// Strains e = B u of a chain or, complex, of one wave on it: K = B* diag(spring) B, C = B* diag(dashpot) B,
/// M = diag(inertia). Of K the scheme's matrix has the part B* diag(solved) B.
template <class Scalar>
struct StepStrains {
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> b;
  Eigen::VectorXd spring, solved, dashpot, inertia;
};

/// One step of the variables sqrt(spring) e and L* v, with the scheme's matrix L L*.
template <class Scalar>
struct StepMatrix {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix step;    ///< strains first, then velocities
  Matrix factor;  ///< L
};

/// With H = dt sqrt(spring) B L^-* and D = dt L^-1 C L^-*: w+ = (1 - D) w - H* e, e+ = e + H w+. Neither H
/// nor D grows with the step where beta and theta are above 0: nothing is lost to scales at a large one.
template <class Scalar>
StepMatrix<Scalar> step_matrix(const StepStrains<Scalar>& s, const TimeScheme& scheme, double dt) {
  using Matrix = typename StepMatrix<Scalar>::Matrix;
  const Matrix damping = s.b.adjoint() * s.dashpot.asDiagonal() * s.b;
  Matrix heavy =
      scheme.theta * dt * damping + scheme.beta * dt * dt * s.b.adjoint() * s.solved.asDiagonal() * s.b;
  heavy.diagonal() += s.inertia.template cast<Scalar>();
  const Matrix l = heavy.llt().matrixL();
  const auto lower = l.template triangularView<Eigen::Lower>();
  const Matrix root = dt * s.spring.cwiseSqrt().asDiagonal() * s.b;
  const Matrix h = lower.solve(root.adjoint()).adjoint();
  const Matrix d = dt * lower.solve(lower.solve(damping).adjoint());
  const Eigen::Index strains = h.rows(), speeds = h.cols();
  const Matrix keep = Matrix::Identity(speeds, speeds) - d;
  Matrix step(strains + speeds, strains + speeds);
  step << Matrix::Identity(strains, strains) - h * h.adjoint(), h * keep, -h.adjoint(), keep;
  return {step, l};
}

}  // namespace fiberchain::reference::detail
