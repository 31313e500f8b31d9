#include "compare/measure/bond_spectra_of.hpp"

#include "compare/measure/linear_chain_of.hpp"

namespace fiberchain::compare {

reference::PronySeries prony_terms(const dem::PronySeries& series) {
  reference::PronySeries terms;
  for (const dem::MaxwellBranch& branch : series) terms.push_back({branch.strength, branch.time});
  return terms;
}

reference::BondSpectra bond_spectra_of(const dem::Fiber& fiber) {
  const dem::MaxwellBranches& own = fiber.branches;
  return {prony_terms(own.stretch), prony_terms(own.shear), prony_terms(own.twist), prony_terms(own.bend)};
}

std::vector<reference::ComplexChainMode> bending_modes_of(const dem::Fiber& fiber, int count) {
  return reference::complex_chain_modes(
      linear_chain_of(fiber), reference::bond_moduli(bond_spectra_of(fiber)), reference::ChainMotion::bending,
      reference::ChainEnds::clamped_free, count);
}

}  // namespace fiberchain::compare
