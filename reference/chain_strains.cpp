#include "reference/chain_strains.hpp"

#include <cmath>

namespace fiberchain::reference::detail {
namespace {

struct OneMotion {
  double spring, dashpot, inertia;
};

OneMotion single_motion(const LinearChain& chain, ChainMotion motion) {
  if (motion == ChainMotion::axial) return {chain.stiffness.stretch, chain.dashpot.stretch, chain.mass};
  return {chain.stiffness.twist, chain.dashpot.twist, chain.inertia};
}

ChainStrains rod(const LinearChain& chain, ChainMotion motion) {
  const int n = chain.bonds;
  const OneMotion one = single_motion(chain, motion);
  ChainStrains strains{Eigen::MatrixXd::Zero(n, n + 1), Eigen::VectorXd::Constant(n, one.spring),
                       Eigen::VectorXd::Constant(n, one.dashpot),
                       Eigen::VectorXd::Constant(n + 1, one.inertia), 1};
  strains.inertia[0] *= chain.end_share;
  strains.inertia[n] *= chain.end_share;
  for (int i = 0; i < n; ++i) {
    strains.b(i, i) = -1;
    strains.b(i, i + 1) = 1;
  }
  return strains;
}

ChainStrains beam(const LinearChain& chain) {
  const int n = chain.bonds;
  const double arm = chain.spacing / 2;
  ChainStrains strains{Eigen::MatrixXd::Zero(2 * n, 2 * n + 2), Eigen::VectorXd(2 * n),
                       Eigen::VectorXd(2 * n), Eigen::VectorXd(2 * n + 2), 2};
  for (int i = 0; i < n; ++i) {
    strains.b.block<2, 4>(2 * i, 2 * i) << -1, -arm, 1, -arm, 0, -1, 0, 1;
    strains.spring.segment<2>(2 * i) << chain.stiffness.shear, chain.stiffness.bend;
    strains.dashpot.segment<2>(2 * i) << chain.dashpot.shear, chain.dashpot.bend;
  }
  for (int i = 0; i <= n; ++i) strains.inertia.segment<2>(2 * i) << chain.mass, chain.inertia;
  strains.inertia.head<2>() *= chain.end_share;
  strains.inertia.tail<2>() *= chain.end_share;
  return strains;
}

}  // namespace

ChainStrains chain_strains(const LinearChain& chain, ChainMotion motion, ChainEnds ends) {
  ChainStrains strains = motion == ChainMotion::bending ? beam(chain) : rod(chain, motion);
  if (ends == ChainEnds::free_free) return strains;
  const Eigen::Index kept = strains.inertia.size() - strains.rigid_motions;
  strains.b = strains.b.rightCols(kept).eval();
  strains.inertia = strains.inertia.tail(kept).eval();
  strains.rigid_motions = 0;
  return strains;
}

SphereShape sphere_shape(Eigen::VectorXcd u, ChainMotion motion, ChainEnds ends) {
  const bool bending = motion == ChainMotion::bending;
  const Eigen::Index stride = bending ? 2 : 1;
  u /= u(u.size() - stride);
  Eigen::VectorXcd all = Eigen::VectorXcd::Zero(u.size() + (ends == ChainEnds::clamped_free ? stride : 0));
  all.tail(u.size()) = u;
  SphereShape shape;
  for (Eigen::Index i = 0; i < all.size(); i += stride) {
    (motion == ChainMotion::twist ? shape.rotation : shape.displacement).push_back(all(i));
    if (bending) shape.rotation.push_back(all(i + 1));
  }
  return shape;
}

std::complex<double> quadratic_root(std::complex<double> m, std::complex<double> c, std::complex<double> k,
                                    std::complex<double> guess) {
  const std::complex<double> root = std::sqrt(c * c - 4.0 * m * k);
  // the larger of the two sums does not cancel; the other root follows from the product k / m
  const std::complex<double> sum = std::abs(c + root) >= std::abs(c - root) ? c + root : c - root;
  if (sum == 0.0) return 0;
  const std::complex<double> one = -sum / (2.0 * m);
  const std::complex<double> other = -2.0 * k / sum;
  return std::abs(one - guess) < std::abs(other - guess) ? one : other;
}

void set_eigenvalue(ChainMode& mode, std::complex<double> eigenvalue) {
  mode.eigenvalue = eigenvalue;
  mode.frequency = std::abs(eigenvalue);
  mode.damping = -eigenvalue.real() / mode.frequency;
  mode.oscillates = eigenvalue.imag() != 0;
}

}  // namespace fiberchain::reference::detail
