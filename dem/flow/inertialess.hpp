#pragma once

#include <memory>

#include "dem/flow/integrate_in_flow.hpp"

// A fiber in a fluid without inertia: the velocities of its spheres follow from the balance of forces.
// Integrated by CVODE (BDF, variable order and step), implicit in the bonds, so that neither stretching waves
// nor stiff bonds bound the step. Newton's matrix is kept in frames that turn with the spheres: it serves
// while the fiber tumbles.
namespace fiberchain::dem {

template <int Dim>
class InertialessMotion {
 public:
  /// `tolerance`: local error allowed, displacements relative to the fiber's length, rotations to 1 rad.
  /// Throws InvalidInput as check() does, and for what is not built.
  InertialessMotion(const FlowCase<Dim>& flow, double tolerance);
  ~InertialessMotion();
  InertialessMotion(InertialessMotion&&) noexcept;

  /// Poses and velocities `time` [s] after the start; times must not fall. Throws Diverged with CVODE's
  /// reason when it gives up, or why the fluid's model does not hold any more.
  ChainState<Dim> at(double time);

  Work work() const;

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace fiberchain::dem
