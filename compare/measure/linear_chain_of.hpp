#pragma once

#include "dem/model/fiber.hpp"
#include "reference/linear_chain.hpp"

namespace fiberchain::compare {

/// The reference's linearized chain of a fiber: the same geometry, mass, springs (by its bond model) and
/// dashpots (by its dashpot law), worked out by reference/ from E, nu, d, rho and not taken from dem/. Throws
/// dem::InvalidInput for a fiber that makes no sense, reference::InvalidArgument for one beyond the
/// reference's range.
reference::LinearChain linear_chain_of(const dem::Fiber& fiber);

}  // namespace fiberchain::compare
