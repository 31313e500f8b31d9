#include "dem/flow/interacting_balance.hpp"

#include "dem/chain/chain_state.hpp"
#include "dem/chain/flow_at_spheres.hpp"
#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
Eigen::VectorXd stacked(const ChainVector<Dim>& parts) {
  constexpr int m = sphere_motions<Dim>;
  Eigen::VectorXd all(parts.size() * m);
  for (std::size_t i = 0; i < parts.size(); ++i) all.segment<m>(i * m) = parts[i];
  return all;
}

template <int Dim>
void unstack(const Eigen::VectorXd& all, ChainVector<Dim>& parts) {
  constexpr int m = sphere_motions<Dim>;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = all.segment<m>(i * m);
}

/// M A, A block-tridiagonal.
template <int Dim>
Eigen::MatrixXd product(const Eigen::MatrixXd& M, const ChainTangent<Dim>& A) {
  constexpr int m = sphere_motions<Dim>;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(M.rows(), M.cols());
  const int n = A.blocks();
  for (int j = 0; j < n; ++j) {
    auto column = result.middleCols<m>(j * m);
    column.noalias() += M.middleCols<m>(j * m) * A.diagonal[j];
    if (j > 0) column.noalias() += M.middleCols<m>((j - 1) * m) * A.upper[j - 1];
    if (j + 1 < n) column.noalias() += M.middleCols<m>((j + 1) * m) * A.lower[j + 1];
  }
  return result;
}

/// I + M C
template <int Dim>
Eigen::MatrixXd damping_matrix(const Chain<Dim>& chain, const Poses<Dim>& poses, const Eigen::MatrixXd& M) {
  ChainTangent<Dim> C(static_cast<int>(poses.size()));
  add_dashpots(chain, poses, 1.0, C);
  return Eigen::MatrixXd::Identity(M.rows(), M.cols()) + product<Dim>(M, C);
}

}  // namespace

template <int Dim>
InteractingBalance<Dim>::InteractingBalance(const Chain<Dim>& chain, const Boundary<Dim>& boundary,
                                            const Fluid& fluid)
    : chain_(chain), fluid_(fluid), loads_(applied_loads(boundary, static_cast<int>(chain.poses.size()))) {
  if (!boundary.clamped.empty())
    throw InvalidInput("clamped spheres are built for hydrodynamics: free_draining only");
}

template <int Dim>
ChainVector<Dim> InteractingBalance<Dim>::velocities(double time, const Poses<Dim>& poses) const {
  const Gradient A = gradient_at(fluid_.flow, time);
  ChainVector<Dim> v = undisturbed<Dim>(A, poses), forces = bond_forces(chain_, poses);
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] += loads_[i];
  const Mobility moves = mobility<Dim>(fluid_, sphere_radius(chain_.fiber), poses);
  Eigen::VectorXd all = stacked<Dim>(v) + moves.motion * stacked<Dim>(forces);
  if (moves.strain.cols() > 0) all += moves.strain * strain_components(A);
  if (damped(chain_.fiber))
    all = damping_matrix(chain_, poses, moves.motion).partialPivLu().solve(all).eval();
  unstack<Dim>(all, v);
  return v;
}

/// (I + M C + gamma M K - gamma G) x = (I + M C) b; how the mobility changes with the place is left to
/// Newton's iterations.
template <int Dim>
void InteractingBalance<Dim>::set_up(double time, const Poses<Dim>& poses, double gamma) {
  constexpr int m = sphere_motions<Dim>;
  const Eigen::MatrixXd M = mobility<Dim>(fluid_, sphere_radius(chain_.fiber), poses).motion;
  Eigen::MatrixXd A = gamma * product<Dim>(M, stiffness(chain_, poses, Boundary<Dim>{}));
  if (damped(chain_.fiber)) {
    damping_ = damping_matrix(chain_, poses, M);
    A += damping_;
  } else {
    A.diagonal().array() += 1;
  }
  const Gradient gradient = gradient_at(fluid_.flow, time);
  for (std::size_t n = 0; n < poses.size(); ++n) {
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) A(n * m + i, n * m + j) -= gamma * gradient[i][j];
    }
  }
  factors_.compute(A);
}

template <int Dim>
void InteractingBalance<Dim>::solve_in_place(ChainVector<Dim>& b) const {
  Eigen::VectorXd all = stacked<Dim>(b);
  if (damping_.size() > 0) all = (damping_ * all).eval();
  unstack<Dim>(factors_.solve(all), b);
}

template class InteractingBalance<2>;
template class InteractingBalance<3>;

}  // namespace fiberchain::dem
