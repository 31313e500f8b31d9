#pragma once

#include "dem/contact/effective_body.hpp"
#include "dem/model/domain.hpp"
#include "dem/model/fiber.hpp"

namespace fiberchain::dem {

/// A body in contact. A wall has infinite radius and mass, a rigid one infinite modulus too.
struct ContactBody {
  double youngs_modulus, poisson_ratio;  ///< [Pa], [-]
  double radius, mass, inertia;          ///< [m], [kg], [kg m^2]

  bool operator==(const ContactBody&) const = default;
};

/// A sphere of the fiber that is not an end; an end sphere of half its mass meets others by the same law. Its
/// surface has the elasticity of these properties, else the fiber's (contact_elasticity).
ContactBody sphere_body(const Fiber& fiber, const ContactProperties& contacts);
ContactBody wall_body(const Domain& domain);

/// The two as one.
EffectiveBody effective_body(const ContactBody& a, const ContactBody& b);

}  // namespace fiberchain::dem
