#pragma once

#include <vector>

#include "dem/assembly/surroundings.hpp"
#include "dem/contact/law.hpp"
#include "dem/fiber.hpp"

namespace fiberchain::dem {

/// A body in contact. A wall has infinite radius and mass, a rigid one infinite modulus too.
struct ContactBody {
  double youngs_modulus, poisson_ratio;  ///< [Pa], [-]
  double radius, mass, inertia;          ///< [m], [kg], [kg m^2]

  bool operator==(const ContactBody&) const = default;
};

ContactBody sphere_body(const Fiber& fiber);
ContactBody wall_body(const Surroundings& surroundings);

/// 1/E* = sum (1 - nu^2)/E, 1/G* = sum (2 - nu)/G, 1/R* = sum 1/R, 1/m* = sum 1/m; damping from the coefficient of
/// restitution with the end of contact at zero force (restitution.hpp), the same ratio along the surface. `step` [s] sets
/// the limit of rolling friction. Throws InvalidInput for a coefficient of restitution outside (0, 1], negative friction.
ContactParameters<double> contact_parameters(const ContactBody& a, const ContactBody& b, const ContactRules& rules,
                                             double step);

/// Largest stable step [s] of the contact, pressed in by `overlap` [m], with its dashpot at the lagged velocity and
/// `neighbors` such contacts about a sphere.
double contact_step_limit(const ContactBody& a, const ContactBody& b, const ContactRules& rules, double overlap, int neighbors);

}  // namespace fiberchain::dem
