#pragma once

#include "dem/model/fiber.hpp"
#include "reference/complex_modes.hpp"

namespace fiberchain::compare {

/// A spectrum as the reference has it.
reference::PronySeries prony_terms(const dem::PronySeries& series);

/// The branches of a fiber's bonds as the reference has them, beside linear_chain_of() of the same fiber.
reference::BondSpectra bond_spectra_of(const dem::Fiber& fiber);

/// The lowest `count` bending modes of the clamped-free linear chain, with its branches and dashpots. Throws
/// as linear_chain_of() and reference::complex_chain_modes().
std::vector<reference::ComplexChainMode> bending_modes_of(const dem::Fiber& fiber, int count);

}  // namespace fiberchain::compare
