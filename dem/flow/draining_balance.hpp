#pragma once

#include <optional>

#include "dem/chain/flow_at_spheres.hpp"

namespace fiberchain::dem {

/// Balance of forces on the spheres of a chain without inertia, each with the drag D of the undisturbed flow:
/// D (V - v) + C v + F = 0, F of the bonds and loads, C of the dashpots. Block-tridiagonal along the chain.
template <int Dim>
class DrainingBalance {
 public:
  DrainingBalance(const Chain<Dim>& chain, const Boundary<Dim>& boundary, const Fluid& fluid);

  /// Velocities and spins of the spheres.
  ChainVector<Dim> velocities(double time, const Poses<Dim>& poses) const;

  /// Prepares to solve (I - gamma dv/dx) x = b near these poses.
  void set_up(double time, const Poses<Dim>& poses, double gamma);

  /// b becomes x.
  void solve_in_place(ChainVector<Dim>& b) const;

 private:
  ChainTangent<Dim> resistance(const Poses<Dim>& poses) const;  ///< D + C

  Chain<Dim> chain_;
  Boundary<Dim> boundary_;
  Fluid fluid_;
  ChainVector<Dim> loads_;
  SphereVector<Dim> drag_;
  std::optional<ChainFactors<sphere_motions<Dim>>> factors_;
  std::optional<ChainTangent<Dim>> resistance_;  ///< where there are dashpots, at the poses of the factors
};

}  // namespace fiberchain::dem
