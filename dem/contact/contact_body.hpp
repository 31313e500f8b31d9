#pragma once

#include "dem/model/domain.hpp"
#include "dem/model/fiber.hpp"

namespace fiberchain::dem {

/// A body in contact. A wall has infinite radius and mass, a rigid one infinite modulus too.
struct ContactBody {
  double youngs_modulus, poisson_ratio;  ///< [Pa], [-]
  double radius, mass, inertia;          ///< [m], [kg], [kg m^2]

  bool operator==(const ContactBody&) const = default;
};

ContactBody sphere_body(const Fiber& fiber);
ContactBody wall_body(const Domain& domain);

/// Two bodies as one: 1/E* = sum (1 - nu^2)/E, 1/G* = sum (2 - nu)/G, 1/R* = sum 1/R, 1/m* = sum 1/m, 1/J* = sum 1/J.
struct EffectiveBody {
  double youngs_modulus, shear_modulus;  ///< E*, G* [Pa]
  double radius, mass, inertia;          ///< R*, m*, J* [m], [kg], [kg m^2]
};

EffectiveBody effective_body(const ContactBody& a, const ContactBody& b);

}  // namespace fiberchain::dem
