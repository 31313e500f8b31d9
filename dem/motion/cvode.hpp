#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "dem/chain/chain_state.hpp"
#include "dem/motion/integrator.hpp"

// SUNDIALS' CVODE (BDF, variable order and step) on the chain itself, total form. Newton's matrix M + g C +
// g^2 K is eliminated along the chain: cost linear in the number of spheres.
namespace fiberchain::dem {

/// Allowed local errors, absolute: what is small in a scene is not known to the integrator.
struct CvodeTolerance {
  double relative = 1e-6;  ///< of the sizes below
  double length;           ///< size of displacements [m]
  double angle;            ///< of rotations [rad]
  double time;             ///< over which they happen [s]: velocities are of size length / time
  long max_steps =
      20000;  ///< from one call of at() to the next, beyond which the tolerance is taken as out of reach
};

/// A medium that drags every sphere along: force and moment drag (velocity there - velocity of the sphere).
template <int Dim>
struct Medium {
  SphereVector<Dim> drag;                                                    ///< [N s/m, N m s]
  std::function<ChainVector<Dim>(double time, const Poses<Dim>&)> velocity;  ///< [m/s, 1/s]
};

/// Follows one chain (dead loads, clamped spheres, a medium).
template <int Dim>
class CvodeMotion {
 public:
  /// Throws InvalidInput for tolerances that are not positive and finite.
  CvodeMotion(const Chain<Dim>& chain, const Boundary<Dim>& boundary, const ChainState<Dim>& start,
              const CvodeTolerance& tolerance, std::optional<Medium<Dim>> medium = std::nullopt);
  ~CvodeMotion();
  CvodeMotion(CvodeMotion&&) noexcept;

  /// The state `time` [s] after the start; times must not fall. Throws Diverged with CVODE's reason when it
  /// gives up.
  ChainState<Dim> at(double time);

  Work work() const;

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace fiberchain::dem
