#pragma once

#include "dem/chain/chain_state.hpp"
#include "dem/motion/kernels/chain_batch.hpp"

// A chain's state into its lane and out of it, and whether it is still in one piece.
namespace fiberchain::dem {

/// The strain of a bond, summed, that the poses stand for.
template <int Dim>
BondHistory<double, Dim> strain_of(const Chain<Dim>& chain, const Poses<Dim>& poses, int bond);

/// Poses, velocities (half a step before, until synchronize()) and, for the incremental form, the strain they stand for.
template <int Dim>
void put_state(ChainBatch<Dim>& block, int lane, const Chain<Dim>& chain, const ChainState<Dim>& state);

/// Velocities as they stand: half a step before.
template <int Dim>
ChainState<Dim> lagged_state(const ChainBatch<Dim>& block, int lane, int spheres);

/// Velocities of this moment.
template <int Dim>
ChainState<Dim> state_now(const ChainBatch<Dim>& block, int lane, int spheres);

/// Whether a bond of that length and that rest length has blown up: not finite, or ten times too long or short.
bool blown_up(double length, double rest_length);

/// First sphere of a lane that has blown up: not finite, or its bond ten times too long or short; -1 if none.
template <int Dim>
int broken_sphere(const ChainBatch<Dim>& block, int lane, const Fiber& fiber);

}  // namespace fiberchain::dem
