#pragma once

#include <cmath>

#include "dem/bond/laws/laws.hpp"
#include "dem/simd/as_numbers.hpp"

namespace fiberchain::dem {

/// The incremental bond with one Maxwell branch beside each spring: the branch's spring is g times as stiff,
/// its dashpot lets it relax within tau (standard linear solid, G(t) = K (1 + g exp(-t / tau))).
/// law_parameters: g [-], tau [s].
struct MaxwellBond : IncrementalBond {
  static constexpr std::string_view name = "maxwell";
  static constexpr bool rolls = false, dissipates = true;

  template <class Real, int Dim>
  struct History {
    BondHistory<Real, Dim> springs, branch;  ///< strain of the bond, of the branch's spring
  };
  template <int Dim>
  static History<double, Dim> start(const BondParameters<double>& bond,
                                    const BondConfiguration<double, Dim>& now) {
    return {IncrementalBond::start(bond, now), {}};
  }
  /// Exact for a constant rate: z -> E z + f d, E = exp(-x), f = (1 - E) / x, x = dt / tau, d the strain of
  /// the step.
  template <class Real, int Dim>
  static void advance(const BondParameters<Real>& bond, History<Real, Dim>& history,
                      const BondConfiguration<Real, Dim>& now, const Real& dt) {
    using std::exp;
    const Real x = dt / bond.own[1], E = exp(-x),
               f = select(x > Real(0.0), (Real(1.0) - E) / (x + Real(1e-300)), Real(1.0));
    dem::advance(history.springs, now.line, now.motion, dt);
    scale(history.branch, E / f);
    dem::advance(history.branch, now.line, now.motion, dt);
    scale(history.branch, f);
  }
  template <bool damped, class Real, int Dim>
  static BondAction<Real, Dim> action(const BondParameters<Real>& bond, const History<Real, Dim>& history,
                                      const BondConfiguration<Real, Dim>& now) {
    const auto branch = IncrementalBond::action<false>(bond, history.branch, now);
    return IncrementalBond::action<damped>(bond, history.springs, now) +
           BondAction<Real, Dim>{bond.own[0] * branch.force, bond.own[0] * branch.moment};
  }
  static double stored_energy(const BondParameters<double>& bond, const History<double, 3>& history,
                              const BondConfiguration<double, 3>& now) {
    return IncrementalBond::stored_energy(bond, history.springs, now) +
           bond.own[0] * IncrementalBond::stored_energy(bond, history.branch, now);
  }
  /// g z K z dt / tau at the middle of the step.
  template <class Real>
  static Real dissipated(const BondParameters<Real>& bond, const History<Real, 3>& before,
                         const BondConfiguration<Real, 3>& now, const Real& dt) {
    History<Real, 3> end = before;
    advance(bond, end, now, dt);
    const Vec<Real, 3> u = Real(0.5) * (before.branch.displacement + end.branch.displacement);
    const Vec<Real, 3> w = Real(0.5) * (before.branch.rotation + end.branch.rotation);
    const BondAction<Real, 3> K = IncrementalBond::action<false>(bond, BondHistory<Real, 3>{u, w}, now);
    return bond.own[0] * dt / bond.own[1] * (dot(K.force, u) + dot(K.moment, w));
  }
  static double bending_angle(const History<double, 3>& history, const BondConfiguration<double, 3>& now) {
    return IncrementalBond::bending_angle(history.springs, now);
  }
  static double largest_stiffness(const BondParameters<double>& bond) { return 1 + bond.own[0]; }

 private:
  template <class Real, int Dim>
  static void scale(BondHistory<Real, Dim>& strain, const Real& factor) {
    Real* numbers = as_numbers<Real>(strain);
    for (std::size_t n = 0; n < numbers_of<BondHistory<Real, Dim>, Real>; ++n)
      numbers[n] = factor * numbers[n];
  }
};

inline constexpr BondForm maxwell_form{100};
template <>
struct BondLawOf<maxwell_form> {
  using type = MaxwellBond;
};

}  // namespace fiberchain::dem
