#pragma once

#include <algorithm>

#include "dem/bond/coupling.hpp"
#include "dem/bond/kinematics.hpp"
#include "dem/model/fiber.hpp"

// The bond law, once for every dimension, number type, equilibrium and integrator. Its energy
//   U = 1/2 K_n (l - l_r)^2 + 1/2 K_t l_0^2 gamma^2 + 1/2 K_bend theta_b^2 + 1/2 K_twist psi^2 + U_c
// with l_r = l_0 (1 - chord theta_b^2); chord = 0 is the paper's bond, 1/24 the corrected one. theta_b and
// psi count from the rest shape in the springs, from straight in l_r; U_c couples twist and bending
// (coupling.hpp).
namespace fiberchain::dem {

template <class Real>
struct BondParameters {
  Real stretch, shear, twist, bend;  ///< K_n, K_t [N/m]; K_twist, K_bend [N m]
  Real rest_length;                  ///< l_0 along the bond's axis at rest [m]
  Real unbent_length;                ///< l_r at theta_b = 0 [m]
  Real chord;                        ///< 0 or 1/24 [-]
  Real rest_moment;                  ///< K_bend times the arc's angle [N m]
  BondCoupling<Real> coupling;
  Real dash_stretch, dash_shear, dash_twist, dash_bend;  ///< dashpots, Eqs 7-10
  Real own[law_parameter_count];                         ///< parameters that one law alone knows
};

inline BondParameters<double> bond_parameters(const Fiber& fiber) {
  const BondStiffness K = bond_stiffness(fiber);
  const BondDashpot c = bond_dashpot(fiber);
  const double chord = fiber.bond_model == BondModel::corrected ? 1.0 / 24.0 : 0.0;
  const double angle = fiber.rest_angle, length = arc_length(fiber);
  BondParameters<double> bond{.stretch = K.stretch,
                              .shear = K.shear,
                              .twist = K.twist,
                              .bend = K.bend,
                              .rest_length = length,
                              .unbent_length = bond_length(fiber) + length * chord * angle * angle,
                              .chord = chord,
                              .rest_moment = K.bend * angle,
                              .coupling = bond_coupling(fiber),
                              .dash_stretch = c.stretch,
                              .dash_shear = c.shear,
                              .dash_twist = c.twist,
                              .dash_bend = c.bend,
                              .own = {}};
  std::copy_n(fiber.law_parameters.begin(), law_parameter_count, bond.own);
  return bond;
}

/// theta_b^2: the rotation about the axes across the bond.
template <class Real>
Real bend_squared(const Vec<Real, 1>& Omega) {
  return Omega[0] * Omega[0];
}

template <class Real>
Real bend_squared(const Vec<Real, 3>& Omega) {
  return Omega[1] * Omega[1] + Omega[2] * Omega[2];
}

/// along in the twist component, across in the bending ones.
template <class Real>
Vec<Real, 1> scale_spin(const Real&, const Real& across, const Vec<Real, 1>& Omega) {
  return {across * Omega[0]};
}

template <class Real>
Vec<Real, 3> scale_spin(const Real& along, const Real& across, const Vec<Real, 3>& Omega) {
  return {along * Omega[0], across * Omega[1], across * Omega[2]};
}

/// N = K_n (l - l_r), from l less the unbent length and theta_b^2.
template <class Real>
Real tension(const BondParameters<Real>& bond, const Real& stretch, const Real& bend_squared) {
  return bond.stretch * (stretch + bond.rest_length * bond.chord * bend_squared);
}

/// Bending moment per angle: K_bend and, for the corrected bond, the moment of its shortened chord.
template <class Real>
Real bending_coefficient(const BondParameters<Real>& bond, const Real& tension) {
  return bond.bend + Real(2.0) * tension * bond.rest_length * bond.chord;
}

/// Shear angle gamma between the bond and the mid-frame's axis, as gamma / |rho_perp|, and l.
template <class Real>
struct ShearAngle {
  Real length;  ///< l = |rho|
  Real ratio;   ///< gamma / |rho_perp|, smooth at gamma = 0
};

/// |rho_perp|^2
template <class Real, int Dim>
Real across_squared(const Vec<Real, Dim>& rho) {
  if constexpr (Dim == 2) return rho[1] * rho[1];
  if constexpr (Dim == 3) return rho[1] * rho[1] + rho[2] * rho[2];
}

template <class Real, int Dim>
ShearAngle<Real> shear_angle(const Vec<Real, Dim>& rho) {
  const Real length = norm(rho);
  const Real scale = Real(1.0) / (length + rho[0]);
  // gamma = 2 atan(|rho_perp| / (l + rho_x))
  return {length, Real(2.0) * scale * atan_ratio(across_squared(rho) * scale * scale)};
}

template <class Real, int Dim>
struct BondStress {
  Vec<Real, Dim> force;    ///< dU/drho, mid-frame [N]
  Spin<Real, Dim> moment;  ///< dU/dOmega, mid-frame [N m]
};

template <class Real, int Dim>
BondStress<Real, Dim> bond_stress(const BondParameters<Real>& bond, const Vec<Real, Dim>& rho,
                                  const Spin<Real, Dim>& Omega) {
  const ShearAngle<Real> shear = shear_angle(rho);
  const Real N = tension(bond, shear.length - bond.unbent_length, bend_squared(Omega));
  const Real inverse_length = Real(1.0) / shear.length;
  // d(gamma^2/2)/drho = (gamma / |rho_perp|) (rho_x rho_perp - |rho_perp|^2 e_x) / l^2
  const Real l0 = bond.rest_length;
  const Real Q = bond.shear * l0 * l0 * shear.ratio * inverse_length * inverse_length;
  const Real pull = N * inverse_length;
  Vec<Real, Dim> force = (pull + Q * rho[0]) * rho;
  force[0] = force[0] - Q * shear.length * shear.length;
  Spin<Real, Dim> moment = scale_spin(bond.twist, bending_coefficient(bond, N), Omega);
  constexpr int about_z = spin_size<Dim> - 1;
  moment[about_z] = moment[about_z] - bond.rest_moment;
  if constexpr (Dim == 3) add_coupling(bond.coupling, rho, Omega, force, moment);
  return {force, moment};
}

/// U [J]
template <class Real, int Dim>
Real bond_energy(const BondParameters<Real>& bond, const Vec<Real, Dim>& rho, const Spin<Real, Dim>& Omega) {
  const ShearAngle<Real> shear = shear_angle(rho);
  const Real N = tension(bond, shear.length - bond.unbent_length, bend_squared(Omega));
  const Real gamma_squared = shear.ratio * shear.ratio * across_squared(rho);
  const Real l0 = bond.rest_length;
  Spin<Real, Dim> strain = Omega;
  constexpr int about_z = spin_size<Dim> - 1;
  strain[about_z] = strain[about_z] - bond.rest_moment / bond.bend;
  const Real springs = Real(0.5) * (N * N / bond.stretch + bond.shear * l0 * l0 * gamma_squared +
                                    dot(strain, scale_spin(bond.twist, bond.bend, strain)));
  if constexpr (Dim == 3) {
    return springs + coupling_energy(bond.coupling, rho, Omega);
  } else {
    return springs;
  }
}

/// What a bond does to its two spheres: forces +-force [N], moments [N m], in the global frame.
template <class Real, int Dim>
struct BondLoads {
  Vec<Real, Dim> force_on_first;
  Spin<Real, Dim> moment_on_first, moment_on_second;
};

/// S^-1 m, S the map from the rate of Omega to the relative spin in the mid-frame:
/// c m + (1 - c) n (n.m), c = h / sin h, h = |Omega| / 2. The identity in the plane.
template <class Real>
Vec<Real, 1> spin_conjugate(const BondKinematics<Real, 2>&, const Vec<Real, 1>& m) {
  return m;
}

template <class Real>
Vec<Real, 3> spin_conjugate(const BondKinematics<Real, 3>& k, const Vec<Real, 3>& m) {
  // tan(h/2)^2 = g.g gives h = 2 atan|g| and sin h = 2 |g| / (1 + g.g)
  const Real gg = dot(k.half_tangent, k.half_tangent);
  const Real c = atan_ratio(gg) * (Real(1.0) + gg);
  const Real along = dot(k.half_tangent, m) * (Real(1.0) - c) / (gg + Real(1e-300));
  return c * m + along * k.half_tangent;
}

/// Forces and moments as derivatives of U: virtual work of (rho, Omega) against displacements and spins,
/// with the spin of the mid-frame 1/2 (w_1 + w_2) - 1/2 g x (w_2 - w_1). Their sum about any point is zero.
template <class Real, int Dim>
BondLoads<Real, Dim> bond_loads(const BondKinematics<Real, Dim>& k, const BondStress<Real, Dim>& stress) {
  const Spin<Real, Dim> half_torque = Real(0.5) * cross(k.separation, stress.force);
  Spin<Real, Dim> mu = spin_conjugate(k, stress.moment);
  if constexpr (Dim == 3) mu = mu + cross(half_torque, k.half_tangent);
  return {k.frame.to_global(stress.force), k.frame.to_global(half_torque + mu),
          k.frame.to_global(half_torque - mu)};
}

}  // namespace fiberchain::dem
