#pragma once

#include <Eigen/Core>
#include <vector>

#include "dem/bond/tangent.hpp"
#include "dem/chain/block_tridiagonal.hpp"
#include "dem/chain/chain.hpp"
#include "dem/model/loads.hpp"

// Balance of forces on every sphere of a chain and its derivative.
namespace fiberchain::dem {

/// Force and moment (or displacement and rotation) of one sphere.
template <int Dim>
using SphereVector = Eigen::Matrix<double, sphere_motions<Dim>, 1>;

template <int Dim>
using ChainVector = std::vector<SphereVector<Dim>>;

template <int Dim>
using ChainTangent = BlockTridiagonal<sphere_motions<Dim>>;

/// Displacement (velocity, force) and rotation (spin, moment) of a sphere in one vector, and back.
template <int Dim>
SphereVector<Dim> motion_of(const Vec<double, Dim>& displacement, const Spin<double, Dim>& rotation) {
  SphereVector<Dim> motion;
  motion.template head<Dim>() = tangent_detail::eigen(displacement);
  motion.template tail<spin_size<Dim>>() = tangent_detail::eigen(rotation);
  return motion;
}

template <int Dim>
Vec<double, Dim> displacement_part(const SphereVector<Dim>& v) {
  Vec<double, Dim> part;
  for (int i = 0; i < Dim; ++i) part[i] = v[i];
  return part;
}

template <int Dim>
Spin<double, Dim> rotation_part(const SphereVector<Dim>& v) {
  Spin<double, Dim> part;
  for (int i = 0; i < spin_size<Dim>; ++i) part[i] = v[Dim + i];
  return part;
}

/// Turns an orientation by the rotation vector phi, exactly.
inline void turn_by_vector(double& angle, const Vec<double, 1>& phi) { angle += phi[0]; }
inline void turn_by_vector(Quaternion<double>& q, const Vec<double, 3>& phi) {
  q = normalized(rotation(phi) * q);
}

/// Largest displacement / length or rotation; not-a-number if there is one.
template <int Dim>
double size_of(const ChainVector<Dim>& motion, double length);

/// Sum over all spheres' motions, or of a force's work on them.
template <int Dim>
double dot_product(const ChainVector<Dim>& a, const ChainVector<Dim>& b);

/// Identity rows at the clamped spheres.
template <int Dim>
void hold_clamped(ChainTangent<Dim>& A, const Boundary<Dim>& boundary);

/// Bond forces and moments on every sphere [N, N m].
template <int Dim>
ChainVector<Dim> bond_forces(const Chain<Dim>& chain, const Poses<Dim>& poses);

/// Bond forces plus `factor` times the loads; zero at clamped spheres.
template <int Dim>
ChainVector<Dim> net_forces(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary,
                            double factor);

/// The loads alone, zero at clamped spheres.
template <int Dim>
ChainVector<Dim> applied_loads(const Boundary<Dim>& boundary, int spheres);

/// Minus the derivative of the net forces by the motions; identity rows at clamped spheres.
template <int Dim>
ChainTangent<Dim> stiffness(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary);

/// Moves the chain by displacements and left (global) rotations that agree with `motion` to first order. With
/// one clamp the spheres turn and the bonds take their change of strain, sphere after sphere away from the
/// clamp: a large rotation then stretches no bond, which saves most of Newton's steps on slender chains.
template <int Dim>
void move(const Chain<Dim>& chain, const Boundary<Dim>& boundary, Poses<Dim>& poses,
          const ChainVector<Dim>& motion);

/// What is out of balance: the largest moment over any cross section of the chain divided by the size of the
/// load's moment, and the same of the force. Bending answers to the first.
struct Imbalance {
  double moment;  ///< relative to max(|P| L, |M|)
  double force;   ///< relative to max(|P|, |M| / L)
};
template <int Dim>
Imbalance imbalance(const Poses<Dim>& poses, const ChainVector<Dim>& net, const Boundary<Dim>& boundary,
                    double length);

}  // namespace fiberchain::dem
