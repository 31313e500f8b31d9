#pragma once

#include "dem/bond/laws/laws.hpp"
#include "dem/chain/chain_state.hpp"

// The bonds of one chain as their law sees them, in double precision: starts, energies and output, not the
// inner loops.
namespace fiberchain::dem {

/// Bond `bond` of a chain in motion.
template <int Dim>
BondConfiguration<double, Dim> configuration(const Chain<Dim>& chain, const ChainState<Dim>& state,
                                             int bond) {
  BondConfiguration<double, Dim> now{
      .first = state.poses[bond], .second = state.poses[bond + 1], .line = {}, .motion = {}};
  if (!chain.natural.empty()) {
    now.first.orientation = turned(now.first.orientation, chain.natural[bond].first);
    now.second.orientation = turned(now.second.orientation, chain.natural[bond].second);
  }
  now.line = bond_vector<double, Dim>(now.second.position - now.first.position, 1 / bond_length(chain.fiber));
  now.motion = {state.velocity[bond + 1] - state.velocity[bond],
                0.5 * (state.spin[bond] + state.spin[bond + 1]), state.spin[bond + 1] - state.spin[bond]};
  return now;
}

/// History of a bond that has just been made in this state; empty where the law has none.
template <class Law, int Dim>
BondLawHistory<Law, double, Dim> start_history(const Chain<Dim>& chain, const ChainState<Dim>& state,
                                               int bond) {
  if constexpr (has_history<Law>) {
    return Law::start(bond_parameters(chain.fiber), configuration(chain, state, bond));
  } else {
    return {};
  }
}

}  // namespace fiberchain::dem
