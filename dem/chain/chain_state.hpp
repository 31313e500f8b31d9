#pragma once

#include <vector>

#include "dem/chain/chain.hpp"
#include "dem/chain/residual.hpp"

namespace fiberchain::dem {

/// A chain in motion: poses, velocities [m/s] and spins [1/s] of its spheres at one moment.
template <int Dim>
struct ChainState {
  Poses<Dim> poses;
  std::vector<Vec<double, Dim>> velocity;
  std::vector<Spin<double, Dim>> spin;
};

/// At rest in the poses given.
template <int Dim>
ChainState<Dim> at_rest(const Poses<Dim>& poses);

/// Kinetic and elastic energy [J], for the energy-based (total) form of the bond law.
template <int Dim>
double total_energy(const Chain<Dim>& chain, const ChainState<Dim>& state);

/// Dashpot forces and moments on every sphere [N, N m].
template <int Dim>
ChainVector<Dim> dashpot_forces(const Chain<Dim>& chain, const Poses<Dim>& poses,
                                const ChainVector<Dim>& velocity);

/// A += factor times the matrix that gives minus the dashpot forces of the velocities.
template <int Dim>
void add_dashpots(const Chain<Dim>& chain, const Poses<Dim>& poses, double factor, ChainTangent<Dim>& A);

/// Masses and moments of inertia, m for the displacements and J for the rotations.
template <int Dim>
SphereVector<Dim> sphere_inertias(const Fiber& fiber, int sphere);

/// inertia M + damping C + stiffness K, identity rows at clamped spheres, with K (no sphere held) given:
/// Newton's matrix of every implicit scheme.
struct MatrixFactors {
  double inertia, damping, stiffness;
};
template <int Dim>
ChainTangent<Dim> motion_matrix(const Chain<Dim>& chain, const Poses<Dim>& poses,
                                const Boundary<Dim>& boundary, ChainTangent<Dim> K,
                                const MatrixFactors& factors);

}  // namespace fiberchain::dem
