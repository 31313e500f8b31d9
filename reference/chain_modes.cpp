#include "reference/chain_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/chain_strains.hpp"
#include "reference/errors.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

/// First-order form in scaled strains and velocities, z = (sqrt(spring) B u, sqrt(M) u'):
/// z' = [[0, S], [-S^T, -S^T diag(dashpot/spring) S]] z, S = sqrt(spring) B / sqrt(M). Skew, hence normal,
/// without damping; with no defective eigenvalue for rigid motions.
MatrixXd first_order(const detail::ChainStrains& strains) {
  const Index e = strains.spring.size();
  const Index u = strains.inertia.size();
  const MatrixXd s = strains.spring.cwiseSqrt().asDiagonal() * strains.b *
                     strains.inertia.cwiseSqrt().cwiseInverse().asDiagonal();
  MatrixXd a = MatrixXd::Zero(e + u, e + u);
  a.topRightCorner(e, u) = s;
  a.bottomLeftCorner(u, e) = -s.transpose();
  a.bottomRightCorner(u, u) = -s.transpose() * strains.dashpot.cwiseQuotient(strains.spring).asDiagonal() * s;
  return a;
}

/// Eigenvalue from its mode by the stationary value of u^T (m x^2 + c x + k) u: the square of the shape's
/// error is what remains.
complex<double> refined(const detail::ChainStrains& strains, const VectorXcd& u, complex<double> guess) {
  const VectorXcd strain = strains.b * u;
  const auto weighted = [](const VectorXd& weight, const VectorXcd& v) {
    return (weight.cast<complex<double>>().array() * v.array().square()).sum();
  };
  return detail::quadratic_root(weighted(strains.inertia, u), weighted(strains.dashpot, strain),
                                weighted(strains.spring, strain), guess);
}

}  // namespace

std::vector<ChainMode> chain_modes(const LinearChain& chain, ChainMotion motion, ChainEnds ends) {
  validate(chain);
  require_between("bonds (dense modes)", chain.bonds, 1, 300);
  const detail::ChainStrains strains = detail::chain_strains(chain, motion, ends);
  const Eigen::EigenSolver<MatrixXd> solver(first_order(strains));
  if (solver.info() != Eigen::Success) throw NoConvergence("modes of the linear chain");

  const VectorXcd values = solver.eigenvalues();
  std::vector<Index> order(static_cast<std::size_t>(values.size()));
  for (Index i = 0; i < values.size(); ++i) order[static_cast<std::size_t>(i)] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return std::abs(values(a)) < std::abs(values(b)); });
  order.erase(order.begin(), order.begin() + strains.rigid_motions);

  const VectorXd scale = strains.inertia.cwiseSqrt().cwiseInverse();
  std::vector<ChainMode> modes;
  for (const Index i : order) {
    if (values(i).imag() < 0) continue;
    const VectorXcd u = scale.asDiagonal() * solver.eigenvectors().col(i).tail(scale.size());
    ChainMode mode{};
    detail::set_eigenvalue(mode, refined(strains, u, values(i)));
    detail::SphereShape shape = detail::sphere_shape(u, motion, ends);
    mode.displacement = std::move(shape.displacement);
    mode.rotation = std::move(shape.rotation);
    modes.push_back(std::move(mode));
  }
  return modes;
}

complex<double> rod_eigenvalue(const LinearChain& chain, ChainMotion motion, ChainEnds ends, int number) {
  validate(chain);
  require_between("number", number, 1, chain.bonds);
  if (motion == ChainMotion::bending) throw InvalidArgument("motion", 0, "axial or twist");
  const bool axial = motion == ChainMotion::axial;
  if (chain.end_share != 1) throw InvalidArgument("end_share", chain.end_share, "1 in the closed form");
  const double angle = ends == ChainEnds::clamped_free
                           ? (2 * number - 1) * std::numbers::pi / (4.0 * chain.bonds + 2)
                           : number * std::numbers::pi / (2.0 * chain.bonds + 2);
  const double factor = 4 * std::sin(angle) * std::sin(angle);
  const double k = factor * (axial ? chain.stiffness.stretch : chain.stiffness.twist);
  const double c = factor * (axial ? chain.dashpot.stretch : chain.dashpot.twist);
  const double m = axial ? chain.mass : chain.inertia;
  const complex<double> fast_oscillation{0, 2 * std::sqrt(k / m)};
  const bool overdamped = c * c > 4 * m * k;
  return detail::quadratic_root(m, c, k, overdamped ? complex<double>{0, 0} : fast_oscillation);
}

double first_bending_damping(int bonds, double bond_damping) {
  require_between("bonds", bonds, 1, 100000);
  require_between("bond_damping", bond_damping, 0, 1e300);
  constexpr double beta_1 = 1.8751040687119611;
  return beta_1 * beta_1 / std::sqrt(20.0) * bond_damping / ((bonds + 0.5) * (bonds + 0.5));
}

}  // namespace fiberchain::reference
