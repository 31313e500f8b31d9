#pragma once

#include "dem/bond/dashpot_matrix.hpp"
#include "dem/motion/bond_step.hpp"
#include "dem/simd/as_numbers.hpp"

// Leapfrog with the dashpots centered in the step: (M + dt/2 C) (v+ - v-) = dt (F - C v-), F - C v- being the
// forces of the lagged scheme. Block-tridiagonal along the chain: eliminated from the first sphere to the
// last.
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
  for (int i = 0; i < Dim; ++i) all[i] = u[i];
  for (int i = 0; i < spin_size<Dim>; ++i) all[Dim + i] = w[i];
  return all;
}

template <class Real, int Dim>
Square<Real, motions<Dim>> inertia_matrix(const MarchParameters<Real, Dim>& p, const SphereStep<Real>& own) {
  Vec<Real, motions<Dim>> diagonal;
  for (int i = 0; i < motions<Dim>; ++i) diagonal[i] = p.step / (i < Dim ? own.impulse : own.angular_impulse);
  return diagonal_matrix(diagonal);
}

/// Half a step times the dashpots of the bond behind sphere `bond`.
template <Physics P, class Real>
DashpotMatrix<Real, P.dimension> half_step_dashpots(const ChainBlock<P, Real>& chain, int bond) {
  constexpr int Dim = P.dimension;
  const MarchParameters<Real, Dim>& p = chain.parameters;
  BondParameters<Real> law = p.bond;
  for (Real* c : {&law.dash_stretch, &law.dash_shear, &law.dash_twist, &law.dash_bend})
    *c = Real(0.5) * p.step * *c;
  const BondVector<Real, Dim> line = bond_vector<Real, Dim>(
      chain.spheres[bond + 1].pose.position - chain.spheres[bond].pose.position, p.inverse_length);
  return dashpot_matrix(law, line.vector, line.inverse_length * line.vector);
}

/// Changes of velocity and spin over the step go into `slots`, from the forces of the spheres.
template <Physics P, class Real>
void eliminate(const ChainBlock<P, Real>& chain, EliminationSlot<Real, P.dimension>* slots) {
  constexpr int Dim = P.dimension, N = motions<Dim>;
  const Square<Real, N> inner = inertia_matrix(chain.parameters, chain.parameters.inner);
  const Square<Real, N> end = inertia_matrix(chain.parameters, chain.parameters.end);
  Square<Real, N> before = zero_matrix<Real, N>();  // what the bond before adds to the diagonal
  Vec<Real, N> pushed;                              // and to the right-hand side
  for (Real& c : pushed.c) c = Real(0.0);
  for (int i = 0; i <= chain.bonds; ++i) {
    DashpotMatrix<Real, Dim> C{};
    const bool last = i == chain.bonds;
    if (!last) C = half_step_dashpots(chain, i);
    EliminationSlot<Real, Dim> slot;
    if (chain.fixed(i)) {
      slot.coupling = zero_matrix<Real, N>();
      for (Real& c : slot.forward.c) c = Real(0.0);
    } else {
      Square<Real, N> A = (chain.is_end(i) ? end : inner) + before;
      if (!last) A = A + C.first;
      factorize(A);
      const MovingSphere<Real, Dim>& sphere = chain.spheres[i];
      slot.forward =
          solved(A, chain.parameters.step * stacked<Real, Dim>(sphere.force, sphere.moment) - pushed);
      slot.coupling = last ? zero_matrix<Real, N>() : solved(A, C.coupling);
    }
    if (!last) {
      const Square<Real, N> down = transposed(C.coupling);
      before = C.second - down * slot.coupling;
      pushed = down * slot.forward;
    }
    slots[i] = slot;
  }
}

/// The velocities at the end of the step.
template <Physics P, class Real>
void kick_with_damping(const ChainBlock<P, Real>& chain) {
  constexpr int Dim = P.dimension;
  auto* slots = as_values<EliminationSlot<Real, Dim>>(chain.workspace);
  eliminate(chain, slots);
  Vec<Real, motions<Dim>> change;
  for (Real& c : change.c) c = Real(0.0);
  for (int i = chain.bonds; i >= 0; --i) {
    change = slots[i].forward - slots[i].coupling * change;
    MovingSphere<Real, Dim>& sphere = chain.spheres[i];
    for (int c = 0; c < Dim; ++c) sphere.velocity[c] = sphere.velocity[c] + change[c];
    for (int c = 0; c < spin_size<Dim>; ++c) sphere.spin[c] = sphere.spin[c] + change[Dim + c];
  }
}

}  // namespace fiberchain::dem
