#pragma once

#include <array>

namespace fiberchain::reference {

// A straight rigid chain of equal spheres of radius R in creeping flow, each acting on the fluid by a force,
// a torque and a stresslet at its center, and moved by what the others do (Faxen's laws with finite spheres:
// the far-field forms of Kim and Karrila, Microhydrodynamics, 1991; Durlofsky, Brady and Bossis, J. Fluid
// Mech. 180 (1987) 21). No lubrication, no higher moments. Along a line of centers the tensors fall apart by
// their angular dependence into scalars, and the rigid body follows from one dense solve: no tensor in space
// is formed.

/// What the spheres do to each other.
enum class ChainCoupling {
  none,                   ///< free draining: drag 6 pi mu R and torque 8 pi mu R^3 of the undisturbed flow
  force_torque,           ///< Rotne-Prager-Yamakawa: every force and torque moves and turns every sphere
  force_torque_stresslet  ///< besides, every sphere resists strain: stresslets from the strain at its center
};

/// N spheres with the given distance of neighbors.
struct RigidChain {
  int spheres;  ///< N, 1 to 500
  ChainCoupling coupling;
  double spacing_ratio = 2;  ///< distance of neighbors over R, 2 (touching) to 1e6
};

/// Bretherton constant Lambda: the angular velocity in the strain rate E_yz about an axis across the chain,
/// free of torque, is Lambda E_yz against the fluid's rotation. Zero for one sphere. Throws InvalidArgument.
double rigid_chain_bretherton(const RigidChain& chain);

/// Period of the chain's Jeffery orbits in simple shear, 2 pi (r_e + 1/r_e)/rate, r_e from Lambda [s]. Throws
/// InvalidArgument unless rate is positive, or there are fewer than 2 spheres.
double rigid_chain_period(const RigidChain& chain, double rate);

/// Force and torque for unit velocity and angular velocity of the whole chain.
struct RigidChainResistance {
  double along;    ///< force in translation along the axis over 6 pi mu R; N if free draining
  double across;   ///< force in translation across over 6 pi mu R; N if free draining
  double turning;  ///< torque in rotation about an axis across over 8 pi mu R^3; N (N^2 + 3)/4 if free
                   ///< draining, touching
  double spin;     ///< torque in rotation about the chain's axis over 8 pi mu R^3; N if free draining
};

/// Throws InvalidArgument.
RigidChainResistance rigid_chain_resistance(const RigidChain& chain);

namespace detail {

/// Action of a sphere on another, separation = (z of the other - z of the acting)/R, either sign. Across:
/// (u_y, omega_x, 2 e_yz) of the other from (F_y, T_x, S_yz) of the acting sphere, over 6 pi mu with R = 1; S
/// is the moment of the forces on the fluid, and 2 e_yz is conjugate to S_yz, so that the whole matrix is
/// symmetric.
std::array<std::array<double, 3>, 3> across_pair(double separation);

/// Along: (u_z, 3/2 e_zz) from (F_z, S_zz), S_xx = S_yy = -S_zz/2.
std::array<std::array<double, 2>, 2> along_pair(double separation);

}  // namespace detail
}  // namespace fiberchain::reference
