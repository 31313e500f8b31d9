#pragma once

#include "dem/bond/incremental.hpp"
#include "dem/bond/laws/total_bond.hpp"

namespace fiberchain::dem {

/// Strain summed over the steps and turned with the bond, as in the paper (Eqs 3-6): the history is the
/// strain.
struct IncrementalBond {
  static constexpr std::string_view name = "incremental";
  static constexpr bool from_poses = false;  ///< orientations and rest shape do not matter; acts by `action`
  static constexpr bool rolls = true;        ///< rolling friction of the bonds is built for it
  static constexpr bool dissipates = false;  ///< nothing but its dashpots takes energy

  template <class Real, int Dim>
  using History = BondHistory<Real, Dim>;

  /// History that carries the loads which the total form has in these poses: where an equilibrium of it
  /// starts.
  template <int Dim>
  static History<double, Dim> start(const BondParameters<double>& bond,
                                    const BondConfiguration<double, Dim>& now) {
    return history_of(bond, now.line.vector, TotalBond::loads(bond, {}, now));
  }

  /// Strain at the end of a step of `dt` that led here.
  template <class Real, int Dim>
  static void advance(const BondParameters<Real>&, History<Real, Dim>& history,
                      const BondConfiguration<Real, Dim>& now, const Real& dt) {
    dem::advance(history, now.line, now.motion, dt);
  }

  /// Springs and, with `damped`, dashpots, acting at the bond's middle.
  template <bool damped, class Real, int Dim>
  static BondAction<Real, Dim> action(const BondParameters<Real>& bond, const History<Real, Dim>& history,
                                      const BondConfiguration<Real, Dim>& now) {
    return incremental_action<damped>(bond, history, now.line, now.motion);
  }

  /// N [N], which sets the largest rolling friction (Eq 21).
  template <class Real, int Dim>
  static Real tension(const BondParameters<Real>& bond, const History<Real, Dim>& history,
                      const BondConfiguration<Real, Dim>& now) {
    return spring_tension(bond, history, now.line);
  }

  /// [J]
  template <class Real, int Dim>
  static Real stored_energy(const BondParameters<Real>& bond, const History<Real, Dim>& history,
                            const BondConfiguration<Real, Dim>& now) {
    return dem::stored_energy(bond, history, unit(now.line.vector));
  }

  /// |theta_t| [rad]
  static double bending_angle(const History<double, 3>& history, const BondConfiguration<double, 3>& now) {
    const Vec<double, 3> e = now.line.inverse_length * now.line.vector;
    return norm(history.rotation - dot(history.rotation, e) * e);
  }

  /// Of any spring at most, over that of the bond's parameters [-].
  static double largest_stiffness(const BondParameters<double>&) { return 1; }
};

}  // namespace fiberchain::dem
