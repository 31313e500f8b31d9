#pragma once

#include <vector>

#include "dem/model/domain.hpp"
#include "dem/contact/hertz_mindlin.hpp"
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

/// 1/E* = sum (1 - nu^2)/E, 1/G* = sum (2 - nu)/G, 1/R* = sum 1/R, 1/m* = sum 1/m; damping from the
/// coefficient of restitution with the end of contact at zero force (restitution.hpp), the same ratio along
/// the surface. `step` [s] sets the limit of rolling friction. Throws InvalidInput for a coefficient of
/// restitution outside (0, 1], negative friction.
ContactParameters<double> contact_parameters(const ContactBody& a, const ContactBody& b,
                                             const ContactProperties& rules, double step);

/// How stiff and how damped contacts make a sphere, for the largest stable step.
struct ContactRates {
  double stiffness;  ///< largest eigenvalue of stiffness over inertia [1/s^2]
  double dashpots;   ///< of normal dashpots and half the tangential ones over inertia [1/s]

  /// Part of what stability allows that contacts use up at a step: dt^2 stiffness / 4 + dt dashpots. The mode
  /// that grows first changes sign every step. There the extrapolated normal dashpots
  /// (ContactParameters::ahead = 1/2) see 3/2 + 1/2 = 2 times the velocity of the step before, the tangential
  /// ones see it once: stability needs 4 M - dt^2 K - 4 dt C_n - 2 dt C_t positive definite.
  double used(double dt) const { return 0.25 * dt * dt * stiffness + dt * dashpots; }
};

/// Of `neighbors` contacts about a sphere, in all directions alike, each pressed in by `overlap` [m]: the
/// larger of translation, (K_n + 2 K_t) / 3 a contact over m*, and rolling all in one sense, 2/3 K_t a
/// contact over J* / R^2 = 2/5 m*; at least two that face each other. The dashpots alike.
ContactRates contact_rates(const ContactBody& a, const ContactBody& b, const ContactProperties& rules,
                           double overlap, int neighbors);

}  // namespace fiberchain::dem
