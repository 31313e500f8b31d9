#pragma once

#include "dem/chain/residual.hpp"

// Stability of an equilibrium under dead loads: the sign of the eigenvalues of its tangent stiffness,
//   K v = lambda (E I / L) W v,  W = 1/L^2 for displacements and 1 for rotations,
// counted by the pivots of the block elimination along the chain (Sylvester's law of inertia), cost linear in
// the spheres.
namespace fiberchain::dem {

enum class Stability {
  stable,    ///< all eigenvalues positive
  neutral,   ///< the lowest is zero within round-off: a family of equilibria, as a column that may buckle
             ///< either way
  unstable,  ///< some are negative
  undecided  ///< the loads have no potential (moments in space)
};

constexpr std::string_view name(Stability stability) {
  switch (stability) {
    case Stability::stable:
      return "stable";
    case Stability::neutral:
      return "neutral";
    case Stability::unstable:
      return "unstable";
    default:
      return "undecided";
  }
}

/// Whether the loads are derivatives of a potential: dead forces always, dead moments in the plane only.
template <int Dim>
bool has_potential(const Boundary<Dim>& boundary);

/// Potential energy U - sum F.x - sum M theta [J]. The boundary must have a potential.
template <int Dim>
double potential_energy(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary);

/// How many eigenvalues lie below `lambda` [-].
template <int Dim>
int eigenvalues_below(const Chain<Dim>& chain, const ChainTangent<Dim>& K, const Boundary<Dim>& boundary,
                      double lambda);

/// K - lambda (E I / L) W at the spheres that are not clamped.
template <int Dim>
ChainTangent<Dim> shifted(const Chain<Dim>& chain, ChainTangent<Dim> K, const Boundary<Dim>& boundary,
                          double lambda);

/// Below this size an eigenvalue is zero within round-off [-]: K's largest entry times the rounding of a
/// number.
template <int Dim>
double zero_eigenvalue(const Chain<Dim>& chain);

template <int Dim>
Stability stability_of(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary);

/// Lowest eigenvalue and its mode, of largest component 1 [L, rad], toward +y.
template <int Dim>
struct LowestMode {
  double eigenvalue;  ///< lambda [-]
  ChainVector<Dim> mode;
};
template <int Dim>
LowestMode<Dim> lowest_mode(const Chain<Dim>& chain, const Poses<Dim>& poses, const Boundary<Dim>& boundary);

/// The stable equilibrium reached from a state by steps that lower the potential energy: Newton's, the matrix
/// shifted by W until it is positive definite, shortened until the energy falls. Throws NoConvergence.
template <int Dim>
Poses<Dim> descend(const Chain<Dim>& chain, Poses<Dim> poses, const Boundary<Dim>& boundary, double tolerance,
                   int& iterations);

}  // namespace fiberchain::dem
