#pragma once

namespace fiberchain::reference {

/// One value for each of a bond's four motions.
struct BondCoefficients {
  double stretch;  ///< along the bond [N/m] or [N s/m]
  double shear;    ///< across the bond [N/m] or [N s/m]
  double twist;    ///< about the bond [N m/rad] or [N m s/rad]
  double bend;     ///< between the two spheres' orientations [N m/rad] or [N m s/rad]
};

/// A straight chain of `bonds` + 1 spheres, linearized; they need not touch. Small motions of bond i, from
/// sphere i to i + 1:
///   stretch u_{i+1} - u_i,  shear w_{i+1} - w_i - (spacing/2)(theta_i + theta_{i+1}),
///   twist phi_{i+1} - phi_i,  bend theta_{i+1} - theta_i,
/// each with a spring and a dashpot beside it.
struct LinearChain {
  int bonds;                   ///< r_f where spheres touch
  double spacing;              ///< distance of neighbors l, 2R where they touch [m]
  double mass;                 ///< of a sphere [kg]
  double inertia;              ///< of a sphere [kg m^2]
  BondCoefficients stiffness;  ///< springs; the shear spring may be replaced (before damping is set)
  BondCoefficients dashpot;    ///< dashpots
  double end_share = 1;        ///< mass and inertia of an end sphere over those of the others
  double spacing_ratio = 1;    ///< s = l / 2R
};

/// What a chain is made of, in SI units.
struct ChainMaterial {
  int bonds;                 ///< r_f, 1 to 100000
  double radius;             ///< R [m]
  double modulus;            ///< Young's modulus E [Pa]
  double poisson_ratio;      ///< nu, above -1 and up to 0.5
  double density;            ///< of the spheres [kg/m^3]
  double spacing_ratio = 1;  ///< s = l / 2R, 1e-3 to 1e6
};

/// Undamped chain: m = 4/3 pi R^3 rho, J = 2/5 m R^2, K_n = pi R E/2, K_t = pi R G/2,
/// K_twist = pi R^3 G/4, K_bend = pi R^3 E/8, G = E/(2(1 + nu)) (Eqs 3-6). With bonds of l = s 2R: E A/l, G
/// A/l, G I_p/l, E I/l, and masses such that the whole has the mass and the moment of inertia about its
/// middle of touching spheres, s bonds + 1 of them (s bonds > 1; a single bond has only ends, of the mass).
/// Throws InvalidArgument.
LinearChain linear_chain(const ChainMaterial& material);

/// The same with the fiber's own mass: m = 2 pi R^3 rho, J = m R^2 / 2, an end sphere with half of both;
/// where spheres do not touch, masses such that the whole has those of the cylinder from end to end.
LinearChain with_cylinder_mass(LinearChain chain);

/// The same with the shear spring of a slender beam, 12 E I / l^3 = 3 K_n / (4 s^2).
LinearChain with_slender_shear(LinearChain chain);

/// The same with another shear modulus, not bound to E: K_t = G A/l, K_twist = G I_p/l. Throws
/// InvalidArgument.
LinearChain with_shear_modulus(LinearChain chain, double shear_modulus);

/// The paper's dashpots, c = xi_b sqrt(2 m K) for forces and xi_b sqrt(2 J K) for torques (Eqs 7-10).
LinearChain with_bond_damping(LinearChain chain, double bond_damping);

/// One retardation time [s] for every motion of the bond (Kelvin-Voigt): c = tau K.
LinearChain with_retardation_time(LinearChain chain, double retardation_time);

/// The paper's dashpot in bending only, c = xi_b sqrt(2 J K_bend), none elsewhere.
LinearChain with_bending_damping(LinearChain chain, double bond_damping);

/// t_b = sqrt(m / K_n) [s] (Eq 11).
double bond_time(const LinearChain& chain);

/// Throws InvalidArgument unless every number of the chain makes sense (dashpots may be zero).
void validate(const LinearChain& chain);

}  // namespace fiberchain::reference
