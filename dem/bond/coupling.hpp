#pragma once

#include "dem/math/vec.hpp"
#include "dem/model/fiber.hpp"

// How twist, bending and shear of the corrected bond depend on each other in space, and on the bond's rest
// arc. dem/bond/README.md derives
//   U_c = -Omega_x (h Omega_perp - a e_z).rho_perp + 1/2 Omega_x^2 (q Omega_perp^2 - 2 t Omega_z)
//         - 1/2 b Omega_y^2
// from the rod between the two spheres: a bond that bends and twists is bowed out of its mid-frame's axis.
namespace fiberchain::dem {

/// Coefficients of U_c; all 0 for the paper's bond.
template <class Real>
struct BondCoupling {
  Real shear;      ///< h [N]
  Real bend;       ///< q [N m]
  Real arc_shear;  ///< a [N], 0 without a rest arc
  Real arc_twist;  ///< t [N m], 0 without a rest arc
  Real arc_bend;   ///< b [N m], 0 without a rest arc
};

inline BondCoupling<double> bond_coupling(const Fiber& fiber) {
  if (fiber.bond_model == BondModel::paper) return {};
  const auto [stretch, shear, C, B] = bond_stiffness(fiber);
  const double l = arc_length(fiber), angle = fiber.rest_angle;
  return {.shear = (1.5 * B - C) / l,
          .bend = (5 * B - 4 * C) / 48,
          .arc_shear = B * angle / l,
          .arc_twist = B * angle / 24,
          .arc_bend = B * B * angle * angle / (12 * C)};
}

/// U_c [J]
template <class Real>
Real coupling_energy(const BondCoupling<Real>& c, const Vec<Real, 3>& rho, const Vec<Real, 3>& Omega) {
  const Real bow = (c.shear * Omega[1]) * rho[1] + (c.shear * Omega[2] - c.arc_shear) * rho[2];
  const Real bend_squared = Omega[1] * Omega[1] + Omega[2] * Omega[2];
  const Real twice = Omega[0] * Omega[0] * (c.bend * bend_squared - Real(2.0) * c.arc_twist * Omega[2]) -
                     c.arc_bend * Omega[1] * Omega[1];
  return Real(0.5) * twice - Omega[0] * bow;
}

/// Adds dU_c/drho and dU_c/dOmega.
template <class Real>
void add_coupling(const BondCoupling<Real>& c, const Vec<Real, 3>& rho, const Vec<Real, 3>& Omega,
                  Vec<Real, 3>& force, Vec<Real, 3>& moment) {
  const Real twist = Omega[0], y = c.shear * Omega[1], z = c.shear * Omega[2] - c.arc_shear;
  const Real twist_squared = twist * twist, tie = c.shear * twist;
  const Real bent =
      c.bend * (Omega[1] * Omega[1] + Omega[2] * Omega[2]) - (c.arc_twist + c.arc_twist) * Omega[2];
  force[1] = force[1] - twist * y;
  force[2] = force[2] - twist * z;
  moment[0] = moment[0] + twist * bent - (y * rho[1] + z * rho[2]);
  moment[1] = moment[1] + (twist_squared * c.bend - c.arc_bend) * Omega[1] - tie * rho[1];
  moment[2] = moment[2] + twist_squared * (c.bend * Omega[2] - c.arc_twist) - tie * rho[2];
}

}  // namespace fiberchain::dem
