#include "compare/measure/linear_chain_of.hpp"

#include <algorithm>
#include <cmath>

namespace fiberchain::compare {

reference::LinearChain linear_chain_of(const dem::Fiber& fiber) {
  dem::check(fiber);
  // nu recovered from E and G carries their rounding
  const double nu = std::min(dem::poisson_ratio(fiber.material), 0.5);
  const bool isotropic = !std::isnan(nu);
  reference::LinearChain chain =
      reference::linear_chain({fiber.aspect_ratio, fiber.diameter / 2, fiber.material.youngs_modulus,
                               isotropic ? nu : 0, fiber.material.density, fiber.spacing});
  if (!isotropic) chain = reference::with_shear_modulus(chain, fiber.material.shear_modulus);
  if (fiber.mass == dem::MassModel::cylinder) chain = reference::with_cylinder_mass(chain);
  if (fiber.bond_model == dem::BondModel::corrected) chain = reference::with_slender_shear(chain);
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
