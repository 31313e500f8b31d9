#pragma once

#include <string_view>

#include "dem/bond/configuration.hpp"

namespace fiberchain::dem {

/// Strain from the poses of the two spheres: loads are the derivatives of the energy U (law.hpp), without
/// history.
struct TotalBond {
  static constexpr std::string_view name = "total";
  static constexpr bool from_poses = true;   ///< needs orientations and the rest shape; acts by `loads`
  static constexpr bool rolls = false;       ///< no rolling friction: built for the incremental form
  static constexpr bool dissipates = false;  ///< nothing but its dashpots takes energy

  template <class Real, int Dim>
  struct History {};

  /// Springs alone; the dashpots are added by bond_step().
  template <class Real, int Dim>
  static BondLoads<Real, Dim> loads(const BondParameters<Real>& bond, const History<Real, Dim>&,
                                    const BondConfiguration<Real, Dim>& now) {
    const BondKinematics<Real, Dim> k = bond_kinematics(now.first, now.second);
    return bond_loads(k, bond_stress<Real, Dim>(bond, k.separation, k.rotation));
  }

  /// U [J]
  template <int Dim>
  static double stored_energy(const BondParameters<double>& bond, const History<double, Dim>&,
                              const BondConfiguration<double, Dim>& now) {
    const BondKinematics<double, Dim> k = bond_kinematics(now.first, now.second);
    return bond_energy(bond, k.separation, k.rotation);
  }

  /// Of any spring at most, over that of the bond's parameters [-].
  static double largest_stiffness(const BondParameters<double>&) { return 1; }
};

}  // namespace fiberchain::dem
