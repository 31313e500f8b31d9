#pragma once

#include "dem/math/unroll.hpp"
#include "dem/motion/bond_step.hpp"
#include "dem/motion/implicit_bond.hpp"
#include "dem/motion/local_flow.hpp"
#include "dem/simd/as_numbers.hpp"

// A kick in which the velocities of a chain depend on each other: (M + dt/2 C) (v+ - v-) = dt (F - C v-), the
// dashpots centered in the step; with the springs (M + dt/2 C + beta dt^2 K) (v+ - v-) = dt (F - C v-). F - C
// v- are the forces of the lagged scheme. Block-tridiagonal along the chain: eliminated from the first sphere
// to the last. K has no part in rigid motion and, like C, acts between two spheres in balance: momentum and
// angular momentum stay.
namespace fiberchain::dem {

/// Of one sphere: change = forward - coupling * change of the next.
template <class Real, int Dim>
struct EliminationSlot {
  Square<Real, motions<Dim>> coupling;
  Vec<Real, motions<Dim>> forward;
};

template <class Real, int Dim>
Vec<Real, motions<Dim>> stacked(const Vec<Real, Dim>& u, const Spin<Real, Dim>& w) {
  Vec<Real, motions<Dim>> all;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < Dim; ++i) all[i] = u[i];
  FIBERCHAIN_UNROLL
  for (int i = 0; i < spin_size<Dim>; ++i) all[Dim + i] = w[i];
  return all;
}

/// m and J of a sphere, in a fluid with the drag of a step solved for [kg], [kg m^2].
template <class Real, int Dim>
Vec<Real, motions<Dim>> inertias_of(const MarchParameters<Real, Dim>& p, const SphereStep<Real>& own) {
  Vec<Real, motions<Dim>> diagonal;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < motions<Dim>; ++i) diagonal[i] = p.step / (i < Dim ? own.impulse : own.angular_impulse);
  return diagonal;
}

/// dt F of a sphere, in a fluid with the drag at v-.
template <Physics P, class Real>
Vec<Real, motions<P.dimension>> impulse_of(const MarchParameters<Real, P.dimension>& p,
                                           const SphereStep<Real>& own,
                                           const MovingSphere<Real, P.dimension>& s,
                                           const LocalFlow<P, Real>& flow) {
  constexpr int Dim = P.dimension;
  Vec<Real, Dim> force = s.force;
  Spin<Real, Dim> moment = s.moment;
  if constexpr (P.fluid) {
    force = force + (own.follow / own.impulse) * (flow.gradient * s.pose.position - s.velocity);
    moment = moment + (own.spin_follow / own.angular_impulse) * (flow.spin - s.spin);
  }
  return p.step * stacked<Real, Dim>(force, moment);
}

/// What the bond between two spheres adds to the matrix.
template <Physics P, class Real>
DashpotMatrix<Real, P.dimension> bond_matrix(const MarchParameters<Real, P.dimension>& p,
                                             const BondParameters<Real>& solved,
                                             const MovingSphere<Real, P.dimension>& first,
                                             const MovingSphere<Real, P.dimension>& second) {
  constexpr int Dim = P.dimension;
  const BondVector<Real, Dim> line =
      bond_vector<Real, Dim>(second.pose.position - first.pose.position, p.inverse_length);
  return dashpot_matrix(solved, line.vector, line.inverse_length * line.vector);
}

/// The same of bond `bond` of a chain; nothing of one that is broken.
template <Physics P, class Real>
DashpotMatrix<Real, P.dimension> bond_matrix(const ChainBlock<P, Real>& chain,
                                             const BondParameters<Real>& solved, int bond,
                                             const MovingSphere<Real, P.dimension>& first,
                                             const MovingSphere<Real, P.dimension>& second) {
  DashpotMatrix<Real, P.dimension> matrix = bond_matrix<P, Real>(chain.parameters, solved, first, second);
  if constexpr (P.fails) scale(matrix, chain.history[bond].failure.intact);
  return matrix;
}

/// B - down X into the lower triangle, which is all that factorize() reads of the symmetric result.
template <class Real, int N>
Square<Real, N> lower_of_rest(const Square<Real, N>& B, const Square<Real, N>& coupling,
                              const Square<Real, N>& X) {
  Square<Real, N> rest;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) {
    FIBERCHAIN_UNROLL
    for (int j = 0; j <= i; ++j) {
      rest[i][j] = B[i][j];
      FIBERCHAIN_UNROLL
      for (int k = 0; k < N; ++k) rest[i][j] = rest[i][j] - coupling[k][i] * X[k][j];
    }
    FIBERCHAIN_UNROLL
    for (int j = i + 1; j < N; ++j) rest[i][j] = Real(0.0);
  }
  return rest;
}

/// A^T x
template <class Real, int N>
Vec<Real, N> transposed_times(const Square<Real, N>& A, const Vec<Real, N>& x) {
  Vec<Real, N> y;
  FIBERCHAIN_UNROLL
  for (int i = 0; i < N; ++i) {
    y[i] = A[0][i] * x[0];
    FIBERCHAIN_UNROLL
    for (int k = 1; k < N; ++k) y[i] = y[i] + A[k][i] * x[k];
  }
  return y;
}

/// Elimination along a chain, sphere by sphere from the first on.
template <Physics P, class Real>
class Elimination {
 public:
  static constexpr int Dim = P.dimension, N = motions<Dim>;

  explicit Elimination(const MarchParameters<Real, Dim>& p)
      : p_(p), inner_(inertias_of(p, p.inner)), end_(inertias_of(p, p.end)), A_(zero_matrix<Real, N>()) {
    for (Real& c : pushed_.c) c = Real(0.0);
  }

  /// A clamped sphere, and the bond behind it.
  void hold(const DashpotMatrix<Real, Dim>& bond, EliminationSlot<Real, Dim>& slot) {
    slot.coupling = zero_matrix<Real, N>();
    for (Real& c : slot.forward.c) c = Real(0.0);
    A_ = bond.second;
    for (Real& c : pushed_.c) c = Real(0.0);
  }

  /// A sphere with all forces on it, and the bond behind it.
  void pass(const MovingSphere<Real, Dim>& sphere, bool is_end, const LocalFlow<P, Real>& flow,
            const DashpotMatrix<Real, Dim>& bond, EliminationSlot<Real, Dim>& slot) {
    FIBERCHAIN_UNROLL
    for (int c = 0; c < N; ++c) {
      FIBERCHAIN_UNROLL
      for (int d = 0; d <= c; ++d) A_[c][d] = A_[c][d] + bond.first[c][d];
    }
    reduce(sphere, is_end, flow, slot);
    slot.coupling = solved(A_, bond.coupling);
    pushed_ = transposed_times(bond.coupling, slot.forward);
    A_ = lower_of_rest(bond.second, bond.coupling, slot.coupling);
  }

  /// The last sphere.
  void finish(const MovingSphere<Real, Dim>& sphere, const LocalFlow<P, Real>& flow,
              EliminationSlot<Real, Dim>& slot) {
    reduce(sphere, true, flow, slot);
  }

 private:
  void reduce(const MovingSphere<Real, Dim>& sphere, bool is_end, const LocalFlow<P, Real>& flow,
              EliminationSlot<Real, Dim>& slot) {
    const Vec<Real, N>& inertia = is_end ? end_ : inner_;
    FIBERCHAIN_UNROLL
    for (int c = 0; c < N; ++c) A_[c][c] = A_[c][c] + inertia[c];
    factorize(A_);
    slot.forward = solved(A_, impulse_of<P, Real>(p_, is_end ? p_.end : p_.inner, sphere, flow) - pushed_);
  }

  const MarchParameters<Real, Dim>& p_;
  Vec<Real, N> inner_, end_;
  Square<Real, N> A_;    ///< of the next sphere, from the bond before it; its lower triangle
  Vec<Real, N> pushed_;  ///< to its right-hand side
};

/// Changes of velocity and spin over the step go into `slots`, from the forces of the spheres.
template <Physics P, class Real>
void eliminate(const ChainBlock<P, Real>& chain, const LocalFlow<P, Real>& flow,
               EliminationSlot<Real, P.dimension>* slots) {
  const BondParameters<Real> law = solved_dashpots<P, Real>(chain.parameters);
  Elimination<P, Real> elimination(chain.parameters);
  for (int i = 0; i < chain.bonds; ++i) {
    const auto bond = bond_matrix<P, Real>(chain, law, i, chain.spheres[i], chain.spheres[i + 1]);
    if (chain.fixed(i)) {
      elimination.hold(bond, slots[i]);
    } else {
      elimination.pass(chain.spheres[i], i == 0, flow, bond, slots[i]);
    }
  }
  if (chain.fixed(chain.bonds)) {
    for (Real& c : slots[chain.bonds].forward.c) c = Real(0.0);
  } else {
    elimination.finish(chain.spheres[chain.bonds], flow, slots[chain.bonds]);
  }
}

/// Calls use(sphere, change) from the last sphere to the first with the change of its velocity and spin over
/// the step.
template <class Real, int Dim, class Use>
void substitute_back(const EliminationSlot<Real, Dim>* slots, int bonds, const Use& use) {
  Vec<Real, motions<Dim>> change = slots[bonds].forward;
  use(bonds, change);
  for (int i = bonds - 1; i >= 0; --i) {
    change = slots[i].forward - slots[i].coupling * change;
    use(i, change);
  }
}

template <class Real, int Dim>
void add_change(MovingSphere<Real, Dim>& sphere, const Vec<Real, motions<Dim>>& change, const Real& part) {
  FIBERCHAIN_UNROLL
  for (int c = 0; c < Dim; ++c) sphere.velocity[c] = sphere.velocity[c] + part * change[c];
  FIBERCHAIN_UNROLL
  for (int c = 0; c < spin_size<Dim>; ++c) sphere.spin[c] = sphere.spin[c] + part * change[Dim + c];
}

/// The velocities `part` of a step on.
template <Physics P, class Real>
void implicit_kick(const ChainBlock<P, Real>& chain, const LocalFlow<P, Real>& flow,
                   const Real& part = Real(1.0)) {
  auto* slots = as_values<EliminationSlot<Real, P.dimension>>(chain.workspace);
  eliminate<P, Real>(chain, flow, slots);
  substitute_back<Real, P.dimension>(slots, chain.bonds,
                                     [&](int i, const Vec<Real, motions<P.dimension>>& change) {
                                       add_change(chain.spheres[i], change, part);
                                     });
}

}  // namespace fiberchain::dem
