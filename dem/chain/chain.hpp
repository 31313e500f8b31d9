#pragma once

#include <vector>

#include "dem/bond/kinematics.hpp"
#include "dem/bond/law.hpp"
#include "dem/model/fiber.hpp"

// A chain of bonded spheres as data: what the spheres and bonds are, and where they stand.
namespace fiberchain::dem {

template <int Dim>
using Poses = std::vector<Pose<double, Dim>>;

template <int Dim>
struct Chain {
  Fiber fiber;
  Poses<Dim> poses;                               ///< aspect_ratio + 1 spheres, at rest
  std::vector<NaturalEnds<double, Dim>> natural;  ///< a bond's ends at rest; empty: no corners
  int surface = 0;                                ///< its number in Domain::pairs
  bool smooth =
      false;  ///< touches others by the cylinders between its spheres and its round ends, not by these
};

/// Stress-free straight chain along x from the origin. Throws InvalidInput for a fiber that makes no sense
/// or is an arc at rest (arc_chain.hpp).
template <int Dim>
Chain<Dim> straight_chain(const Fiber& fiber);

/// Stress-free chain with a corner: bonds up to sphere `corner` along x, the rest along y.
/// Throws InvalidInput unless 0 < corner < aspect_ratio.
template <int Dim>
Chain<Dim> cornered_chain(const Fiber& fiber, int corner);

/// The same chain with its spheres numbered from the other end.
Chain<3> renumbered(const Chain<3>& chain);

/// Strain of bond i: between spheres i and i + 1.
template <int Dim>
BondKinematics<double, Dim> bond_kinematics(const Chain<Dim>& chain, const Poses<Dim>& poses, int bond);

/// U of the whole chain [J]
template <int Dim>
double elastic_energy(const Chain<Dim>& chain, const Poses<Dim>& poses);

/// Axis of a sphere: the direction that its fiber has there.
inline Vec<double, 2> axis(const Pose<double, 2>& pose) {
  return {std::cos(pose.orientation), std::sin(pose.orientation)};
}
inline Vec<double, 3> axis(const Pose<double, 3>& pose) {
  return rotate(pose.orientation, Vec<double, 3>{1, 0, 0});
}

}  // namespace fiberchain::dem
