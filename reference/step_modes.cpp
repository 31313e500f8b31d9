#include "reference/step_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "reference/chain_strains.hpp"
#include "reference/errors.hpp"
#include "reference/step_matrix.hpp"

namespace fiberchain::reference {
namespace {

using std::complex;

/// ln(1 + y), every digit of a small y kept.
complex<double> log_of_one_and(complex<double> y) {
  return {std::log1p((2 + y.real()) * y.real() + y.imag() * y.imag()) / 2,
          std::atan2(y.imag(), 1 + y.real())};
}

/// z - 1 of the mode u by the stationary value of u^T P(z) u: the square of the shape's error is what
/// remains.
complex<double> refined(const detail::ChainStrains& s, const TimeScheme& scheme, double dt,
                        const Eigen::VectorXcd& u, complex<double> guess) {
  const Eigen::VectorXcd strain = s.b * u;
  const auto weighted = [](const Eigen::VectorXd& weight, const Eigen::VectorXcd& v) {
    return (weight.cast<complex<double>>().array() * v.array().square()).sum();
  };
  const complex<double> damping = dt * weighted(s.dashpot, strain),
                        spring = dt * dt * weighted(s.spring, strain);
  const complex<double> heavy = weighted(s.inertia, u) + scheme.theta * damping + scheme.beta * spring;
  return detail::quadratic_root(heavy, damping + spring, spring, guess);
}

StepMode mode_of(complex<double> less_one, double dt) {
  const complex<double> eigenvalue = log_of_one_and(less_one) / dt;
  return {1.0 + less_one, eigenvalue, std::abs(eigenvalue), -eigenvalue.real() / std::abs(eigenvalue)};
}

}  // namespace

std::vector<StepMode> step_modes(const LinearChain& chain, const TimeScheme& scheme, ChainMotion motion,
                                 ChainEnds ends, double dt) {
  validate(chain);
  validate(scheme);
  require_between("bonds (dense modes)", chain.bonds, 1, 100);
  require_positive("dt", dt);
  const detail::ChainStrains s = detail::chain_strains(chain, motion, ends);
  const auto matrix =
      detail::step_matrix<double>({s.b, s.spring, s.spring, s.dashpot, s.inertia}, scheme, dt);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix.step);
  if (solver.info() != Eigen::Success) throw NoConvergence("modes of the amplification matrix");
  const Eigen::VectorXcd z = solver.eigenvalues();
  const Eigen::MatrixXcd upper = matrix.factor.transpose().cast<complex<double>>();

  std::vector<Eigen::Index> order(static_cast<std::size_t>(z.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto size = [&](Eigen::Index i) { return std::abs(log_of_one_and(z(i) - 1.0)); };
  std::ranges::stable_sort(order, {}, size);
  order.erase(order.begin(), order.begin() + s.rigid_motions);

  std::vector<StepMode> modes;
  for (const Eigen::Index i : order) {
    if (z(i).imag() < 0) continue;
    const Eigen::VectorXcd w = solver.eigenvectors().col(i).tail(s.inertia.size());
    const Eigen::VectorXcd u = upper.triangularView<Eigen::Upper>().solve(w);
    modes.push_back(mode_of(refined(s, scheme, dt, u, z(i) - 1.0), dt));
  }
  return modes;
}

}  // namespace fiberchain::reference
