#pragma once

#include <optional>

namespace fiberchain::dem {

struct ContactLaw;  // dem/contact/contact_law.hpp

/// Surface properties of a scene, the same for every pair of bodies.
struct ContactProperties {
  double restitution = 1;                     ///< normal coefficient of restitution, 0 < e <= 1
  double friction = 0;                        ///< Coulomb's mu
  double rolling_friction = 0;                ///< mu_r: a moment of at most mu_r R* F_n against rolling
  std::optional<double> youngs_modulus = {};  ///< of the fibers' surface [Pa]; left out: each fiber's own
  std::optional<double> poisson_ratio = {};   ///< likewise [-]
  const ContactLaw* law = nullptr;  ///< the law they are parameters of; null: the first of ContactLaws
};

}  // namespace fiberchain::dem
