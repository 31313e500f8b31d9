#pragma once

#include <Eigen/Dense>
#include <span>

#include "reference/damped_elastica.hpp"
#include "reference/legendre_beam.hpp"

namespace fiberchain::reference::detail {

/// The inextensible beam discretized in arc length, theta = sum_k q_k phi_k. With the nodal kernel
/// G_jk = int over the beam of what moves beyond both s_j and s_k, Lagrange's equations are those of a chain
/// of pendulums,
///   Phi^T h + (rotary) q'' + K (q + tau q') = 0,
///   h_j = sum_k G_jk (cos(theta_j - theta_k) theta_k'' + sin(theta_j - theta_k) theta_k'^2),
/// so energy is kept exactly by the discretization itself.
/// State: q, q' and the energy dissipated since the release, 2 n + 1 numbers.
struct ElasticaMotion {
  ElasticaMotion(const BeamLayout& layout, int modes);

  Eigen::Index n() const { return beam.phi.cols(); }
  Eigen::Index size() const { return 2 * n() + 1; }

  void rhs(std::span<const double> state, std::span<double> derivative) const;
  /// Column-major derivative of rhs by the state; entries that vanish are left alone.
  void jacobian(std::span<const double> state, std::span<double> entries) const;
  /// State at rest for a release.
  Eigen::VectorXd start(const Release& release) const;
  /// Equilibrium q under a dead tip load.
  Eigen::VectorXd equilibrium(double load) const;
  BeamSample sample(double time, std::span<const double> state) const;
  /// M(q).
  Eigen::MatrixXd mass(const Eigen::VectorXd& cosine, const Eigen::VectorXd& sine) const;

  BeamLayout layout;
  LegendreBeam beam;         ///< in the coordinates of the undamped linear modes of this layout
  Eigen::MatrixXd velocity;  ///< rows: sqrt(mass) r' per node, and the tip's; kernel = velocity^T velocity
  Eigen::MatrixXd kernel;    ///< G
  Eigen::MatrixXd rotary;    ///< part of the mass matrix from the rotation of the sections
};

}  // namespace fiberchain::reference::detail
