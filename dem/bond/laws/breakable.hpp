#pragma once

#include "dem/bond/laws/laws.hpp"

namespace fiberchain::dem {

/// A bond law with history whose bonds break for good once their tension exceeds a strength, the last of the
/// fiber's law_parameters [N]. The flag of a bond is part of its history: it lies in lanes for the kernels,
/// is saved and restored with the state, and no other law has it. Assembly::is_broken() reads it.
template <class Base>
struct Breakable {
  static constexpr std::string_view name = "breakable";
  static constexpr bool from_poses = false, rolls = false, dissipates = Base::dissipates;
  static_assert(!Base::from_poses && has_history<Base>);

  template <class Real, int Dim>
  struct History {
    BondLawHistory<Base, Real, Dim> base;
    Real intact;  ///< 1, 0 once broken; the last number (packing_law.hpp)
  };

  template <int Dim>
  static History<double, Dim> start(const BondParameters<double>& bond,
                                    const BondConfiguration<double, Dim>& now) {
    return {Base::start(bond, now), 1};
  }

  template <class Real, int Dim>
  static void advance(const BondParameters<Real>& bond, History<Real, Dim>& history,
                      const BondConfiguration<Real, Dim>& now, const Real& dt) {
    Base::advance(bond, history.base, now, dt);
    const auto torn = Base::tension(bond, history.base, now) > bond.own[law_parameter_count - 1];
    history.intact = select(torn, Real(0.0), history.intact);
  }

  /// [N]
  template <class Real, int Dim>
  static Real tension(const BondParameters<Real>& bond, const History<Real, Dim>& history,
                      const BondConfiguration<Real, Dim>& now) {
    return history.intact * Base::tension(bond, history.base, now);
  }

  template <bool damped, class Real, int Dim>
  static BondAction<Real, Dim> action(const BondParameters<Real>& bond, const History<Real, Dim>& history,
                                      const BondConfiguration<Real, Dim>& now) {
    const BondAction<Real, Dim> whole = Base::template action<damped>(bond, history.base, now);
    return {history.intact * whole.force, history.intact * whole.moment};
  }

  /// [J]
  template <int Dim>
  static double stored_energy(const BondParameters<double>& bond, const History<double, Dim>& history,
                              const BondConfiguration<double, Dim>& now) {
    return history.intact * Base::stored_energy(bond, history.base, now);
  }

  static double bending_angle(const History<double, 3>& history, const BondConfiguration<double, 3>& now) {
    return Base::bending_angle(history.base, now);
  }

  static double largest_stiffness(const BondParameters<double>& bond) {
    return Base::largest_stiffness(bond);
  }
};

}  // namespace fiberchain::dem
