#pragma once

#include <cstddef>

#include "dem/bond/law.hpp"
#include "dem/math/near_one.hpp"

// Maxwell branches beside a bond's springs in a march. A branch's strain z relaxes within tau and follows the
// bond's, dz/dt = d(strain)/dt - z / tau: over a step of constant rate exactly
//   z -> E z + f d,  E = exp(-dt/tau),  f = (1 - E) tau/dt,
// d the change of the bond's strain. Its spring pulls with g K z.
namespace fiberchain::dem {

/// One branch in steps of dt.
template <class Real>
struct BranchStep {
  Real keep;      ///< E
  Real gain;      ///< f
  Real strength;  ///< g
  /// Energy that it dissipates in a step, over g K: a z^2 + b z d + c d^2, z before the step.
  Real spent_strain, spent_both, spent_change;
};

/// Branches beside each spring of a bond, in this order in `steps`.
template <class Real>
struct BondBranches {
  const BranchStep<Real>* steps = nullptr;
  int stretch = 0, shear = 0, twist = 0, bend = 0;
};

/// How many components the strain of shear and of bending has.
template <int Dim>
inline constexpr int across_size = Dim - 1;

/// Moves the strains of `count` branches, N components each, a step on in which the bond's strain changes by
/// `change`; returns their sum times g. Where `moves` is false they stay.
template <int N, class Real, class Mask>
Vec<Real, N> advance_branches(const BranchStep<Real>* steps, int count, Real* strains,
                              const Vec<Real, N>& change, const Mask& moves) {
  Vec<Real, N> sum;
  for (int c = 0; c < N; ++c) sum[c] = Real(0.0);
  for (int j = 0; j < count; ++j) {
    const Real keep = select(moves, steps[j].keep, Real(1.0));
    for (int c = 0; c < N; ++c) {
      const Real strain = keep * strains[j * N + c] + steps[j].gain * change[c];
      strains[j * N + c] = strain;
      sum[c] = sum[c] + steps[j].strength * strain;
    }
  }
  return sum;
}

/// Energy that `count` branches store, over K/2 [strain^2].
template <int N, class Real>
Real stored_in_branches(const BranchStep<Real>* steps, int count, const Real* strains) {
  Real sum(0.0);
  for (int n = 0; n < N * count; ++n) sum = sum + steps[n / N].strength * (strains[n] * strains[n]);
  return sum;
}

/// Energy that they dissipate in a step, over K [strain^2].
template <int N, class Real>
Real spent_in_branches(const BranchStep<Real>* steps, int count, const Real* strains,
                       const Vec<Real, N>& change) {
  Real sum(0.0);
  for (int j = 0; j < count; ++j) {
    const BranchStep<Real>& s = steps[j];
    for (int c = 0; c < N; ++c) {
      const Real z = strains[j * N + c], d = change[c];
      sum = sum + s.strength * (z * (s.spent_strain * z + s.spent_both * d) + s.spent_change * (d * d));
    }
  }
  return sum;
}

/// Goes through a bond's memory, spring by spring in the order of BondBranches. With `keeps_strain` the
/// bond's strain at the step before stands in front of those of its branches, and the strain itself is given;
/// else its change is.
template <bool keeps_strain, class Number, class Real>
class BranchReader {
 public:
  BranchReader(const BranchStep<Real>* steps, Number* memory) : steps_(steps), memory_(memory) {}

  /// As advance_branches(), the strain before the step exchanged for `strain`.
  template <int N, class Mask>
  Vec<Real, N> advance(int count, const Vec<Real, N>& strain, const Mask& moves) {
    const Vec<Real, N> change = change_of<N>(strain, moves);
    if constexpr (keeps_strain) {
      for (int c = 0; c < N; ++c) memory_[c] = strain[c];
    }
    const Vec<Real, N> sum = advance_branches<N>(steps_, count, memory_ + before<N>, change, moves);
    pass<N>(count);
    return sum;
  }

  template <int N>
  Real stored(int count) {
    if (count == 0) return Real(0.0);
    const Real sum = stored_in_branches<N>(steps_, count, memory_ + before<N>);
    pass<N>(count);
    return sum;
  }

  template <int N, class Mask>
  Real spent(int count, const Vec<Real, N>& strain, const Mask& moves) {
    if (count == 0) return Real(0.0);
    const Real sum = spent_in_branches<N>(steps_, count, memory_ + before<N>, change_of<N>(strain, moves));
    pass<N>(count);
    return sum;
  }

  /// Numbers of `count` branches of N components.
  template <int N>
  static constexpr std::size_t size(int count) {
    return count == 0 ? 0 : before<N> + static_cast<std::size_t>(N * count);
  }

 private:
  template <int N>
  static constexpr int before = keeps_strain ? N : 0;

  template <int N, class Mask>
  Vec<Real, N> change_of(const Vec<Real, N>& strain, const Mask& moves) const {
    Vec<Real, N> change;
    for (int c = 0; c < N; ++c) {
      if constexpr (keeps_strain) {
        change[c] = select(moves, strain[c] - memory_[c], Real(0.0));
      } else {
        change[c] = strain[c];
      }
    }
    return change;
  }

  template <int N>
  void pass(int count) {
    steps_ += count;
    memory_ += size<N>(count);
  }

  const BranchStep<Real>* steps_;
  Number* memory_;
};

/// Numbers that the branches of a bond keep.
template <bool keeps_strain, int Dim>
constexpr std::size_t branch_memory(int stretch, int shear, int twist, int bend) {
  using Reader = BranchReader<keeps_strain, double, double>;
  return Reader::template size<1>(stretch) + Reader::template size<across_size<Dim>>(shear) +
         (Dim == 3 ? Reader::template size<1>(twist) : 0) + Reader::template size<across_size<Dim>>(bend);
}

/// A bond's strains by spring, or their change.
template <class Real, int Dim>
struct BondStrains {
  Vec<Real, 1> stretch;               ///< l - l_r [m]
  Vec<Real, across_size<Dim>> shear;  ///< l_0 gamma [m]
  Vec<Real, 1> twist;                 ///< psi [rad]
  Vec<Real, across_size<Dim>> bend;   ///< theta_b [rad]
};

/// Energy that a bond's branches store [J].
template <bool keeps_strain, int Dim, class Real>
Real branch_energy(const BondParameters<Real>& bond, const BondBranches<Real>& branches, const Real* memory) {
  BranchReader<keeps_strain, const Real, Real> reader(branches.steps, memory);
  Real sum = bond.stretch * reader.template stored<1>(branches.stretch);
  sum = sum + bond.shear * reader.template stored<across_size<Dim>>(branches.shear);
  if constexpr (Dim == 3) sum = sum + bond.twist * reader.template stored<1>(branches.twist);
  return Real(0.5) * (sum + bond.bend * reader.template stored<across_size<Dim>>(branches.bend));
}

/// Energy that they dissipate in a step, from their strains before it [J].
template <bool keeps_strain, int Dim, class Real, class Mask>
Real branch_dissipation(const BondParameters<Real>& bond, const BondBranches<Real>& branches,
                        const Real* memory, const BondStrains<Real, Dim>& strains, const Mask& moves) {
  BranchReader<keeps_strain, const Real, Real> reader(branches.steps, memory);
  Real sum = bond.stretch * reader.spent(branches.stretch, strains.stretch, moves);
  sum = sum + bond.shear * reader.spent(branches.shear, strains.shear, moves);
  if constexpr (Dim == 3) sum = sum + bond.twist * reader.spent(branches.twist, strains.twist, moves);
  return select(moves, sum + bond.bend * reader.spent(branches.bend, strains.bend, moves), Real(0.0));
}

}  // namespace fiberchain::dem
