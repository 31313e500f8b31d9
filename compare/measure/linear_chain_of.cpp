#include "compare/measure/linear_chain_of.hpp"

#include <algorithm>

namespace fiberchain::compare {

reference::LinearChain linear_chain_of(const dem::Fiber& fiber) {
  dem::check(fiber);
  // nu recovered from E and G carries their rounding
  const double nu = std::min(dem::poisson_ratio(fiber.material), 0.5);
  reference::LinearChain chain = reference::linear_chain(
      {fiber.aspect_ratio, fiber.diameter / 2, fiber.material.youngs_modulus, nu, fiber.material.density});
  if (fiber.bond_model == dem::BondModel::corrected) chain.stiffness.shear = 0.75 * chain.stiffness.stretch;
  switch (fiber.dashpots) {
    case dem::DashpotLaw::retardation_time:
      return reference::with_retardation_time(chain, fiber.retardation_time);
    case dem::DashpotLaw::bending_only:
      return reference::with_bending_damping(chain, fiber.bond_damping);
    default:
      return reference::with_bond_damping(chain, fiber.bond_damping);
  }
}

}  // namespace fiberchain::compare
