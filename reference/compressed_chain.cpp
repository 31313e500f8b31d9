#include "reference/compressed_chain.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "reference/errors.hpp"
#include "reference/filament_buckling.hpp"
#include "reference/gsl_root.hpp"

namespace fiberchain::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// With R = E I = 1: E A = 4, l_0 = 2, so K_n = 2 and K_bend = 1/2.
constexpr double rest_length = 2;
constexpr double stretch_stiffness = 2;
constexpr double bend_stiffness = 0.5;
// Drag 6 pi mu R and torque 8 pi mu R^3 over 3 pi mu.
constexpr double sphere_drag = 2;
constexpr double sphere_torque = 8.0 / 3;

void validate(const CompressedChain& chain, double number) {
  require_between("spheres", chain.spheres, 3, 300);
  if (!(chain.poisson_ratio > -1 && chain.poisson_ratio <= 0.5)) {
    throw InvalidArgument("poisson_ratio", chain.poisson_ratio, "above -1, up to 0.5");
  }
  require_positive_or_infinite("stretch_factor", chain.stretch_factor);
  require_between("transverse_rate", chain.transverse_rate, 0, 10);
  require_positive("number", number);
  require_between("number", number, 0, max_filament_number);
}

/// 3 pi mu e over E I/R^4
double flow_strength(const CompressedChain& chain, double number) {
  return number / std::pow(2.0 * chain.spheres, 4);
}

VectorXd rest_positions(Index n) {
  return VectorXd::LinSpaced(n, -static_cast<double>(n - 1), static_cast<double>(n - 1));
}

/// Balance K_n (x_{i+1} - 2 x_i + x_{i-1}) = drag x_i inside, with the rest length at both ends.
VectorXd balanced_positions(Index n, double stiffness, double drag) {
  MatrixXd matrix = drag * MatrixXd::Identity(n, n);
  VectorXd load = VectorXd::Zero(n);
  for (Index i = 0; i + 1 < n; ++i) {
    matrix.block<2, 2>(i, i) += stiffness * Eigen::Matrix2d{{1, -1}, {-1, 1}};
    load.segment<2>(i) += stiffness * rest_length * Eigen::Vector2d(-1, 1);
  }
  return matrix.ldlt().solve(load);
}

struct Axial {
  VectorXd positions;
  VectorXd forces;
};

Axial axial_state(const CompressedChain& chain, double number) {
  const Index n = chain.spheres;
  const double drag = sphere_drag * flow_strength(chain, number);
  const bool rigid = std::isinf(chain.stretch_factor);
  const VectorXd x =
      rigid ? rest_positions(n) : balanced_positions(n, stretch_stiffness * chain.stretch_factor, drag);
  VectorXd force(n - 1);
  double sum = 0;
  for (Index i = 0; i + 1 < n; ++i) force(i) = sum += drag * x(i);
  return {x, force};
}

/// Second derivatives of the energy by w_0, theta_0, w_1, theta_1 ...
MatrixXd stiffness_matrix(const CompressedChain& chain, const Axial& state) {
  const Index n = chain.spheres;
  const double shear = stretch_stiffness / (2 * (1 + chain.poisson_ratio)) * rest_length * rest_length;
  MatrixXd h = MatrixXd::Zero(2 * n, 2 * n);
  for (Index i = 0; i + 1 < n; ++i) {
    const double length = state.positions(i + 1) - state.positions(i);
    const Eigen::Vector4d slope(-1 / length, 0, 1 / length, 0);
    const Eigen::Vector4d gamma = slope - Eigen::Vector4d(0, 0.5, 0, 0.5);
    const Eigen::Vector4d bend(0, -1, 0, 1);
    h.block<4, 4>(2 * i, 2 * i) += state.forces(i) * length * slope * slope.transpose() +
                                   shear * gamma * gamma.transpose() +
                                   bend_stiffness * bend * bend.transpose();
  }
  return h;
}

/// Orthonormal columns that span the motions symmetric about the middle without translation (sign = 1), or
/// the antisymmetric ones (sign = -1).
MatrixXd motions(Index n, double sign) {
  MatrixXd basis = MatrixXd::Zero(2 * n, n);
  Index columns = 0;
  const auto add = [&](Index one, Index other, double factor) {
    if (one == other && factor < 0) return;
    VectorXd column = VectorXd::Zero(2 * n);
    column(one) += 1;
    column(other) += factor;
    basis.col(columns++) = column.normalized();
  };
  for (Index i = 0; i <= (n - 1) / 2; ++i) {
    add(2 * i, 2 * (n - 1 - i), sign);
    add(2 * i + 1, 2 * (n - 1 - i) + 1, -sign);
  }
  basis.conservativeResize(Eigen::NoChange, columns);
  if (sign < 0) return basis;
  VectorXd translation = VectorXd::Zero(2 * n);
  for (Index i = 0; i < n; ++i) translation(2 * i) = 1;
  const MatrixXd inside = basis.transpose() * translation;
  const MatrixXd q = inside.householderQr().householderQ();
  return basis * q.rightCols(columns - 1);
}

/// sigma C u = (transverse drag - H/strength) u, C the drag and torque coefficients, in the variables sqrt(C)
/// u. Translation is an eigenvector, so what is orthogonal to it stays so.
ChainGrowthMode growth_mode(const CompressedChain& chain, double number, int mode) {
  const Index n = chain.spheres;
  VectorXd scale(2 * n);
  VectorXd drive(2 * n);
  for (Index i = 0; i < n; ++i) {
    scale.segment<2>(2 * i) << 1 / std::sqrt(sphere_drag), 1 / std::sqrt(sphere_torque);
    drive.segment<2>(2 * i) << chain.transverse_rate, 0;
  }
  const MatrixXd h = stiffness_matrix(chain, axial_state(chain, number)) / flow_strength(chain, number);
  MatrixXd a = -(scale.asDiagonal() * h * scale.asDiagonal());
  a.diagonal() += drive;
  const bool even = mode % 2 == 1;
  const MatrixXd q = motions(n, even ? 1 : -1);
  const MatrixXd reduced = q.transpose() * a * q;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(reduced);
  const Index column = reduced.rows() - 1 - mode / 2;
  if (solver.info() != Eigen::Success || column < 0) throw NoConvergence("modes of a compressed chain");
  VectorXd u = scale.cwiseProduct(q * solver.eigenvectors().col(column));
  u /= u(2 * n - 2);
  ChainGrowthMode found{solver.eigenvalues()(column), {}, {}};
  for (Index i = 0; i < n; ++i) {
    found.displacement.push_back(u(2 * i));
    found.rotation.push_back(u(2 * i + 1));
  }
  return found;
}

}  // namespace

CompressedState compressed_state(const CompressedChain& chain, double number) {
  validate(chain, number);
  const Axial state = axial_state(chain, number);
  return {{state.positions.begin(), state.positions.end()}, {state.forces.begin(), state.forces.end()}};
}

ChainGrowthMode chain_growth_mode(const CompressedChain& chain, double number, int mode) {
  validate(chain, number);
  require_between("mode", mode, 0, chain.spheres - 2);
  return growth_mode(chain, number, mode);
}

double chain_buckling_threshold(const CompressedChain& chain, int mode) {
  validate(chain, 1);
  require_between("mode", mode, 1, std::min(chain.spheres - 2, max_filament_mode));
  const double filament = buckling_threshold(mode, chain.transverse_rate);
  // in logarithms: growth is about c - threshold/number
  const double found = detail::find_root(
      [&](double ln_number) { return growth_mode(chain, std::exp(ln_number), mode).growth; },
      std::log(filament / 4), std::log(filament * 8), {}, "buckling threshold of a chain");
  return std::exp(found);
}

}  // namespace fiberchain::reference
