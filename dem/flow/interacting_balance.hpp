#pragma once

#include <Eigen/LU>

#include "dem/flow/mobility.hpp"

namespace fiberchain::dem {

/// Balance of forces on the spheres of a chain without inertia that act on each other through the fluid:
/// v = V + M (F - C v) + N E, F of the bonds and loads, C of the dashpots, M and N the mobility. Dense: time
/// grows with the cube of the number of spheres.
template <int Dim>
class InteractingBalance {
 public:
  /// Throws InvalidInput for clamped spheres: that is not built.
  InteractingBalance(const Chain<Dim>& chain, const Boundary<Dim>& boundary, const Fluid& fluid);

  ChainVector<Dim> velocities(double time, const Poses<Dim>& poses) const;
  void set_up(double time, const Poses<Dim>& poses, double gamma);
  void solve_in_place(ChainVector<Dim>& b) const;

 private:
  Chain<Dim> chain_;
  Fluid fluid_;
  ChainVector<Dim> loads_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
  Eigen::MatrixXd damping_;  ///< I + M C where there are dashpots, else empty
};

}  // namespace fiberchain::dem
