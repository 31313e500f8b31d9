#pragma once

#include <array>
#include <vector>

#include "dem/assembly/fiber_block.hpp"

// A kick of a fiber some of whose spheres are held.
namespace fiberchain::dem {

/// Along and about x, y, z: of velocity and spin, of force and moment.
using SixNumbers = std::array<double, 6>;

/// What a kick must change of the velocity and spin of a sphere: the components that are held.
struct HeldChange {
  int sphere;
  std::array<bool, 6> is{};
  SixNumbers change{};  ///< [m/s], [1/s]
};

/// Of each sphere.
struct HeldKick {
  std::vector<SixNumbers> change;   ///< of velocity and spin [m/s], [1/s]
  std::vector<SixNumbers> impulse;  ///< of what holds it [N s], [N m s]; 0 of what is not held
};

/// Whether a kick solves for the bonds, as in the step; at the velocities of the poses' moment dashpots are
/// not solved for.
enum class KickMatrix { masses, bonds, springs };

/// A d = dt F + i, where d is given of what is held and i is 0 of all else: A has the masses, and dt/2 C +
/// beta dt^2 K of bonds that are solved for (implicit_kick.hpp). What A has of bonds acts between two spheres
/// in balance: the impulses i and the forces from outside change the momentum, nothing else. Forces are those
/// of `spheres`, `parts` how much of each bond acts (bond_parts).
HeldKick held_kick(const GroupKind& kind, const std::vector<MovingSphere<double, 3>>& spheres,
                   const std::vector<HeldChange>& held, KickMatrix matrix, const std::vector<double>& parts);

/// How much of each bond of a fiber acts in the kick to come by histories of a block (BondFailure::intact): 1
/// but of those that break or are broken.
std::vector<double> bond_parts(const GroupKind& kind, const double* histories, int lane);

}  // namespace fiberchain::dem
