#pragma once

#include <Eigen/Dense>

namespace fiberchain::reference::detail {

/// A cantilever's angle theta(s) = sum_k q_k phi_k(s), 0 <= s <= 1. The phi_k span the polynomials that
/// vanish at s = 0: the clamp holds by itself, the free end's conditions are natural ones.
struct LegendreBeam {
  Eigen::VectorXd nodes;      ///< Gauss-Legendre points s_j
  Eigen::VectorXd weights;    ///< their weights
  Eigen::MatrixXd phi;        ///< phi_k(s_j), nodes x modes
  Eigen::VectorXd phi_tip;    ///< phi_k(1)
  Eigen::VectorXd stiffness;  ///< int phi_k'^2 ds; int phi_i' phi_k' ds = 0 for i != k
  /// integral(j, k) f(s_k) summed over k = int_0^{s_j} f ds, exact for polynomials below degree `nodes`
  Eigen::MatrixXd integral;
};

/// The basis with phi_k' the orthonormal Legendre polynomials, so all stiffnesses are 1.
/// Throws InvalidArgument unless 2 <= modes <= 60 and modes + 2 <= nodes <= 200.
LegendreBeam legendre_beam(int modes, int nodes);

/// The same space of functions in the coordinates of its own undamped modes, lowest first. The mass matrix in
/// those of legendre_beam is given by a factor of it, mass = factor^T factor (whose singular values keep the
/// digits that the mass matrix would lose); it becomes the identity and the stiffnesses omega_k^2. In
/// these coordinates the fast motions do not disturb the slow ones by rounding.
LegendreBeam in_modal_coordinates(const LegendreBeam& beam, const Eigen::MatrixXd& factor);

/// sqrt(weights) w at the nodes, w = int theta ds: the mass matrix is factor^T factor.
Eigen::MatrixXd mass_factor(const LegendreBeam& beam);

}  // namespace fiberchain::reference::detail
