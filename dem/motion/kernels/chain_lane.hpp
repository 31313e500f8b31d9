#pragma once

#include "dem/chain/chain_state.hpp"
#include "dem/motion/kernels/chain_batch.hpp"

// A chain's state into its lane and out of it, and the check for a chain that has blown up.
namespace fiberchain::dem {

/// Poses, velocities (half a step before, until synchronize()) and the history of bonds that start there.
template <int Dim>
void put_state(ChainBatch<Dim>& block, int lane, const Chain<Dim>& chain, const ChainState<Dim>& state);

/// Velocities as they stand: half a step before.
template <int Dim>
ChainState<Dim> lagged_state(const ChainBatch<Dim>& block, int lane, int spheres);

/// Velocities of this moment.
template <int Dim>
ChainState<Dim> state_now(const ChainBatch<Dim>& block, int lane, int spheres);

/// Elastic energy of the Maxwell branches of a lane's bonds [J].
template <int Dim>
double branch_energy(const ChainBatch<Dim>& block, int lane, const Chain<Dim>& chain, BondForm form);

/// Whether a bond of that length and that rest length has blown up: not finite, or ten times too long or
/// short.
bool blown_up(double length, double rest_length);

/// First sphere of a lane that has blown up: not finite, or its bond ten times too long or short; -1 if none.
template <int Dim>
int broken_sphere(const ChainBatch<Dim>& block, int lane, const Fiber& fiber);

}  // namespace fiberchain::dem
