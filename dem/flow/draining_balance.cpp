#include "dem/flow/draining_balance.hpp"

#include "dem/chain/chain_state.hpp"

namespace fiberchain::dem {

template <int Dim>
DrainingBalance<Dim>::DrainingBalance(const Chain<Dim>& chain, const Boundary<Dim>& boundary,
                                      const Fluid& fluid)
    : chain_(chain),
      boundary_(boundary),
      fluid_(fluid),
      loads_(applied_loads(boundary, static_cast<int>(chain.poses.size()))),
      drag_(drag_of<Dim>(fluid, chain.fiber)) {}

template <int Dim>
ChainTangent<Dim> DrainingBalance<Dim>::resistance(const Poses<Dim>& poses) const {
  ChainTangent<Dim> A(static_cast<int>(poses.size()));
  for (auto& block : A.diagonal) block.diagonal() = drag_;
  add_dashpots(chain_, poses, 1.0, A);
  hold_clamped(A, boundary_);
  return A;
}

template <int Dim>
ChainVector<Dim> DrainingBalance<Dim>::velocities(double time, const Poses<Dim>& poses) const {
  ChainVector<Dim> v = undisturbed<Dim>(gradient_at(fluid_.flow, time), poses);
  const ChainVector<Dim> forces = bond_forces(chain_, poses);
  const bool with_dashpots = damped(chain_.fiber);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const SphereVector<Dim> pushed = forces[i] + loads_[i];
    v[i] = with_dashpots ? (drag_.cwiseProduct(v[i]) + pushed).eval()
                         : (v[i] + pushed.cwiseQuotient(drag_)).eval();
  }
  for (const int sphere : boundary_.clamped) v[sphere].setZero();
  if (with_dashpots) dem::solve_in_place<sphere_motions<Dim>>(resistance(poses), v);
  return v;
}

/// (D + C + gamma K - gamma D G) x = (D + C) b, G the change of the undisturbed velocity with the place.
template <int Dim>
void DrainingBalance<Dim>::set_up(double time, const Poses<Dim>& poses, double gamma) {
  ChainTangent<Dim> A = stiffness(chain_, poses, Boundary<Dim>{});
  const Gradient gradient = gradient_at(fluid_.flow, time);
  Eigen::Matrix<double, Dim, Dim> stirred;
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) stirred(i, j) = gamma * drag_[0] * gradient[i][j];
  }
  for (int i = 0; i < A.blocks(); ++i) {
    for (auto* block : {&A.lower[i], &A.diagonal[i], &A.upper[i]}) *block *= gamma;
    A.diagonal[i].diagonal() += drag_;
    A.diagonal[i].template topLeftCorner<Dim, Dim>() -= stirred;
  }
  add_dashpots(chain_, poses, 1.0, A);
  hold_clamped(A, boundary_);
  factors_.emplace(A);
  if (damped(chain_.fiber)) resistance_.emplace(resistance(poses));
}

template <int Dim>
void DrainingBalance<Dim>::solve_in_place(ChainVector<Dim>& b) const {
  if (resistance_) {
    b = product(*resistance_, b);
  } else {
    for (auto& own : b) own = drag_.cwiseProduct(own);
  }
  for (const int sphere : boundary_.clamped) b[sphere].setZero();
  factors_->solve_in_place(b);
}

template class DrainingBalance<2>;
template class DrainingBalance<3>;

}  // namespace fiberchain::dem
