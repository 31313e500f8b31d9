#pragma once

#include <Eigen/Core>

#include "dem/chain/residual.hpp"
#include "dem/model/fluid.hpp"

// Hydrodynamic interactions between the spheres of a fiber: equal spheres without lubrication.
namespace fiberchain::dem {

/// v = u + motion F + strain E: velocities and spins of all spheres by the forces and moments on them and the
/// strain rate E of the undisturbed flow, u its velocity and spin at the spheres.
struct Mobility {
  Eigen::MatrixXd motion;  ///< symmetric, positive definite; a block a pair of spheres
  Eigen::MatrixXd strain;  ///< by the five components of strain_components(); 0 columns without stresslets
};

/// E in the orthonormal basis of symmetric traceless matrices that Mobility::strain is for.
Eigen::Matrix<double, 5, 1> strain_components(const Gradient& A);

/// The Rotne-Prager-Yamakawa mobility of spheres of radius R, also where they overlap (Wajnryb, Mizerski, Zuk
/// & Szymczak, J. Fluid Mech. 731 (2013) R3), or with the stresslets that keep them rigid, by Faxen's laws
/// (Durlofsky, Brady & Bossis, J. Fluid Mech. 180 (1987) 21, without its lubrication). Throws Diverged where
/// spheres with stresslets overlap by more than a tenth of 2R: there the far field means nothing.
template <int Dim>
Mobility mobility(const Fluid& fluid, double radius, const Poses<Dim>& poses);

}  // namespace fiberchain::dem
