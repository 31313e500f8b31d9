#include "compare/measure/bond_spectra_of.hpp"

#include "compare/measure/linear_chain_of.hpp"

namespace fiberchain::compare {
namespace {

reference::PronySeries series_of(const dem::PronySeries& series) {
  reference::PronySeries terms;
  for (const dem::MaxwellBranch& branch : series) terms.push_back({branch.strength, branch.time});
  return terms;
}

}  // namespace

reference::BondSpectra bond_spectra_of(const dem::Fiber& fiber) {
  const dem::MaxwellBranches& own = fiber.branches;
  return {series_of(own.stretch), series_of(own.shear), series_of(own.twist), series_of(own.bend)};
}

std::vector<reference::ComplexChainMode> bending_modes_of(const dem::Fiber& fiber, int count) {
  return reference::complex_chain_modes(
      linear_chain_of(fiber), reference::bond_moduli(bond_spectra_of(fiber)), reference::ChainMotion::bending,
      reference::ChainEnds::clamped_free, count);
}

}  // namespace fiberchain::compare
