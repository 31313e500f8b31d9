#pragma once

#include "dem/chain/residual.hpp"
#include "dem/model/fluid.hpp"

// What an undisturbed flow does at the spheres of a chain.
namespace fiberchain::dem {

/// Stokes' drag of a sphere alone, for every motion of it: 6 pi mu R [N s/m] and 8 pi mu R^3 [N m s].
template <int Dim>
SphereVector<Dim> drag_of(const Fluid& fluid, const Fiber& fiber);

/// Velocity [m/s] and spin [1/s] of the undisturbed flow with the gradient A at every sphere.
template <int Dim>
ChainVector<Dim> undisturbed(const Gradient& A, const Poses<Dim>& poses);

}  // namespace fiberchain::dem
