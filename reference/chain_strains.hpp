#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "reference/chain_modes.hpp"

namespace fiberchain::reference::detail {

/// The linear chain as strains e = B u of its bonds, one row each, and the spring and dashpot of each
/// strain, so that K = B^T diag(spring) B and C = B^T diag(dashpot) B; `inertia` is the diagonal of M.
/// Unknowns: per sphere one displacement or rotation, for bending displacement then rotation; the spheres
/// held are left out. Strains: per bond, for bending shear then bend.
struct ChainStrains {
  Eigen::MatrixXd b;
  Eigen::VectorXd spring;
  Eigen::VectorXd dashpot;
  Eigen::VectorXd inertia;
  int rigid_motions;  ///< independent u with B u = 0
};

ChainStrains chain_strains(const LinearChain& chain, ChainMotion motion, ChainEnds ends);

/// A mode's shape per sphere, those held included, scaled so that the last sphere's displacement (twist:
/// rotation) is 1. The one a motion does not have is empty.
struct SphereShape {
  std::vector<std::complex<double>> displacement;
  std::vector<std::complex<double>> rotation;
};

/// From the unknowns of chain_strains().
SphereShape sphere_shape(Eigen::VectorXcd u, ChainMotion motion, ChainEnds ends);

/// Root of m x^2 + c x + k = 0 nearest to `guess`.
std::complex<double> quadratic_root(std::complex<double> m, std::complex<double> c, std::complex<double> k,
                                    std::complex<double> guess);

/// Fills eigenvalue, frequency, damping and oscillates.
void set_eigenvalue(ChainMode& mode, std::complex<double> eigenvalue);

}  // namespace fiberchain::reference::detail
