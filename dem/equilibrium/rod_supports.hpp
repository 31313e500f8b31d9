#pragma once

#include <array>

#include "dem/equilibrium/rod_problem.hpp"

// Supports of a rod as they enter its equations: at a held sphere the motions are written in the support's
// own directions, and the rows of the held ones say where they shall be.
namespace fiberchain::dem {

/// Motions of one sphere in its support's directions: column k of `directions` is what unit motion k does.
struct HeldSphere {
  std::array<bool, 6> held{};
  bool turned = false;  ///< directions are not the global axes
  Eigen::Matrix<double, 6, 6> directions = Eigen::Matrix<double, 6, 6>::Identity();
  SphereVector<3> missing =
      SphereVector<3>::Zero();                     ///< to where the held motions shall be, at a load factor
  SphereVector<3> rate = SphereVector<3>::Zero();  ///< of that by the load factor
  int outer = -1, inner = -1;                      ///< motions of a universal joint's two axes
  bool any() const { return held[0] || held[1] || held[2] || held[3] || held[4] || held[5]; }
};

/// All spheres at a state; supports count from `start`.
std::vector<HeldSphere> held_spheres(const RodProblem& problem, const Poses<3>& start, const Poses<3>& poses,
                                     double factor);

/// K q + a dfactor = r in the motions of the supports.
struct RodSystem {
  ChainTangent<3> K;
  ChainVector<3> unbalanced;  ///< r
  ChainVector<3> by_factor;   ///< a
  std::vector<HeldSphere> held;
};

RodSystem rod_system(const RodProblem& problem, const Poses<3>& start, const Poses<3>& poses, double factor);

/// The tangent for counting its eigenvalues: held motions alone with themselves, lambda (E I / L) W off
/// (stability.hpp).
ChainTangent<3> held_tangent(const RodProblem& problem, const RodSystem& system, double lambda);

/// Motions of the supports as displacements and rotations.
void to_global(const std::vector<HeldSphere>& held, ChainVector<3>& motion);

}  // namespace fiberchain::dem
