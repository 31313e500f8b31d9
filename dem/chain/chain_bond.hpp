#pragma once

#include "dem/bond/laws/laws.hpp"
#include "dem/chain/chain_state.hpp"

// The bonds of one chain as their law sees them, in double precision: starts, energies and output, not the
// inner loops.
namespace fiberchain::dem {

/// Calls use(now) with bond `bond` of a chain in motion.
template <int Dim, class Use>
auto with_configuration(const Chain<Dim>& chain, const ChainState<Dim>& state, int bond, const Use& use) {
  Pose<double, Dim> first = state.poses[bond], second = state.poses[bond + 1];
  if (!chain.natural.empty()) {
    first.orientation = turned(first.orientation, chain.natural[bond].first);
    second.orientation = turned(second.orientation, chain.natural[bond].second);
  }
  const auto line = bond_vector<double, Dim>(second.position - first.position, 1 / bond_length(chain.fiber));
  const RelativeMotion<double, Dim> motion{state.velocity[bond + 1] - state.velocity[bond],
                                           0.5 * (state.spin[bond] + state.spin[bond + 1]),
                                           state.spin[bond + 1] - state.spin[bond]};
  return use(BondConfiguration<double, Dim>{first, second, line, motion});
}

/// History of a bond that has just been made in this state; empty where the law has none.
template <class Law, int Dim>
BondLawHistory<Law, double, Dim> start_history(const Chain<Dim>& chain, const ChainState<Dim>& state,
                                               int bond) {
  if constexpr (has_history<Law>) {
    return with_configuration(chain, state, bond, [&](const BondConfiguration<double, Dim>& now) {
      return Law::start(bond_parameters(chain.fiber), now);
    });
  } else {
    return {};
  }
}

}  // namespace fiberchain::dem
