#pragma once

#include "dem/bond/law.hpp"

namespace fiberchain::dem {

/// Change of a bond's strain (rho, Omega) by the motions of its spheres, to first order about the given
/// kinematics.
template <int Dim>
struct StrainChange {
  Vec<double, Dim> separation;  ///< R_m^T (u_2 - u_1) - a_m x rho [m]
  Spin<double, Dim> rotation;   ///< S^-1 (a_2 - a_1) [rad]
};

/// From the difference of the displacements and the rotations a_1, a_2, with the spin of the mid-frame
/// a_m = 1/2 (a_1 + a_2) - 1/2 g x (a_2 - a_1).
template <int Dim>
StrainChange<Dim> strain_change(const BondKinematics<double, Dim>& k, const Vec<double, Dim>& displacement,
                                const Spin<double, Dim>& first, const Spin<double, Dim>& second) {
  Spin<double, Dim> mean = 0.5 * (first + second), relative = second - first;
  if constexpr (Dim == 3) {
    relative = k.frame.to_local(relative);
    mean = k.frame.to_local(mean) - 0.5 * cross(k.half_tangent, relative);
  }
  return {k.frame.to_local(displacement) - cross(mean, k.separation), spin_conjugate(k, relative)};
}

}  // namespace fiberchain::dem
