#pragma once

#include <string_view>

#include "dem/model/fiber.hpp"
#include "dem/model/velocity_gradient.hpp"

namespace fiberchain::dem {

/// What the spheres of a fiber do to each other through the fluid.
enum class Hydrodynamics {
  free_draining,  ///< nothing: each feels the drag of the undisturbed flow, as the paper
  interactions,   ///< Rotne-Prager-Yamakawa, translation and rotation, no lubrication
  stresslets      ///< the same with the stresslets of rigid spheres, no lubrication
};

constexpr std::string_view name(Hydrodynamics hydrodynamics) {
  switch (hydrodynamics) {
    case Hydrodynamics::interactions:
      return "interactions";
    case Hydrodynamics::stresslets:
      return "stresslets";
    default:
      return "free_draining";
  }
}

/// A creeping Newtonian fluid in a flow.
struct Fluid {
  double viscosity;  ///< mu [Pa s]
  Flow flow;
  Hydrodynamics hydrodynamics = Hydrodynamics::free_draining;
  bool compressible = false;  ///< allow a gradient with non-zero trace, which Stokes' drag is not made for
};

/// Throws InvalidInput unless mu > 0 and finite, the gradient (at the start) is finite, has trace 0 within
/// round-off where not `compressible`, and in the plane keeps the fiber in it.
template <int Dim>
void check(const Fluid& fluid);

/// Stokes' drag on a sphere alone: force over velocity and torque over spin. Throws InvalidInput for a fiber
/// whose spheres do not touch, spacing other than 1.
struct StokesDrag {
  double translation;  ///< 6 pi mu R [N s/m]
  double rotation;     ///< 8 pi mu R^3 [N m s]
};
StokesDrag stokes_drag(const Fluid& fluid, const Fiber& fiber);

}  // namespace fiberchain::dem
