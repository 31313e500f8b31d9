#pragma once

#include "dem/chain/chain_state.hpp"

namespace fiberchain::dem {

/// The shortest rotation that brings the direction of `from` to that of `to`; neither may be zero.
Quaternion<double> rotation_between(const Vec<double, 3>& from, const Vec<double, 3>& to);

/// A chain in its rest shape, turned as a whole, its first sphere's center at `first`, all spheres at one
/// velocity.
ChainState<3> placed(const Chain<3>& chain, const Quaternion<double>& turn, const Vec<double, 3>& first,
                     const Vec<double, 3>& velocity);

/// From the first sphere to the last; the first sphere's axis where they coincide (a ring).
Vec<double, 3> end_to_end(const Poses<3>& poses);

/// Where a fiber starts.
struct FiberStart {
  Vec<double, 3> position;    ///< of the first sphere's center [m]
  Vec<double, 3> direction;   ///< of the fiber there; its length does not matter
  Vec<double, 3> velocity{};  ///< of all spheres [m/s]
};

/// The chain's rest shape there: the axis that it has at its first sphere along the direction.
/// Throws InvalidInput for a direction of no length or a number that is not finite.
ChainState<3> placed(const Chain<3>& chain, const FiberStart& start);

}  // namespace fiberchain::dem
