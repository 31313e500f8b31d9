#pragma once

#include <string_view>
#include <vector>

#include "dem/chain/residual.hpp"
#include "dem/model/rod.hpp"

// A rod in space, held and loaded in any way, and its balance of forces at a load factor.
namespace fiberchain::dem {

/// How forces per length reach the spheres.
enum class LineLoads {
  lumped,     ///< half a bond's on each of its spheres: order 2
  consistent  ///< with the moments +- w l^2 / 12 of a cubic between the spheres, e_1 x w on the first,
              ///< -e_2 x w on the second, which cancel but at the ends of the load and at corners: order 4
};

constexpr std::string_view name(LineLoads rule) {
  return rule == LineLoads::lumped ? "lumped" : "consistent";
}

struct RodProblem {
  Chain<3> chain = {};  ///< rest shape: straight_chain<3>, cornered_chain<3>, or of rod_shapes.hpp
  std::vector<RodSupport> supports = {};
  std::vector<RodPointLoad> point_loads = {};
  std::vector<RodLineLoad> line_loads = {};
  Vec<double, 3> gravity{};  ///< [m/s^2] the rod's weight, steady: of MassModel::cylinder a force per length
                             ///< rho A g, of MassModel::spheres that of its spheres
  bool planar = false;       ///< every sphere stays in its plane z = const and turns about z only
  LineLoads line_load_rule = LineLoads::consistent;
  Poses<3> start = {};  ///< near an equilibrium at load factor 0, from where supports count; empty: the rest
                        ///< shape's
};

/// Most bonds of a rod: zero_eigenvalue() grows with their third power.
inline constexpr int most_rod_bonds = 20000;

/// Throws InvalidInput for more bonds than that, spheres that the rod does not have, supports twice at one
/// sphere or that hold nothing, rods that can move or turn as a whole along or about an axis that nothing
/// holds, values that are not finite, prescribed turns without a clamp, planar rods that leave the plane,
/// materials with branches.
void check(const RodProblem& problem);

/// Forces and moments on every sphere at a load factor, bonds and loads, held directions included [N, N m].
ChainVector<3> rod_forces(const RodProblem& problem, const Poses<3>& poses, double factor);

/// Minus its derivative by displacements and left (global) rotations, loads that follow included, nothing
/// held.
ChainTangent<3> rod_stiffness(const RodProblem& problem, const Poses<3>& poses, double factor);

/// Whether the loads have a potential, so that the sign of the lowest eigenvalue tells stability: dead forces
/// have one; dead moments and following loads where `planar` and following forces nowhere.
bool has_potential(const RodProblem& problem);

/// What the supports bear: minus rod_forces at the held directions of every supported sphere, in the order of
/// problem.supports [N, N m], global axes.
ChainVector<3> rod_reactions(const RodProblem& problem, const Poses<3>& poses, double factor);

}  // namespace fiberchain::dem
