#pragma once

#include "dem/equilibrium/rod_problem.hpp"

// Loads of a rod on its spheres and their derivatives.
namespace fiberchain::dem {

/// Every load in full times one of two factors.
struct LoadFactors {
  double steady;  ///< of those that do not go with the load factor
  double scaled;  ///< of those that do
};

/// forces += loads at the poses.
void add_loads(const RodProblem& problem, const Poses<3>& poses, const LoadFactors& factors,
               ChainVector<3>& forces);

/// K -= derivative of the loads by displacements and left (global) rotations.
void add_load_stiffness(const RodProblem& problem, const Poses<3>& poses, const LoadFactors& factors,
                        ChainTangent<3>& K);

/// Whether there is a load that does not go with the load factor.
bool has_steady_loads(const RodProblem& problem);

}  // namespace fiberchain::dem
