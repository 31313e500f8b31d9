#pragma once

#include <vector>

#include "dem/chain/chain.hpp"
#include "dem/contact/effective_body.hpp"
#include "dem/model/domain.hpp"
#include "dem/model/fiber.hpp"

namespace fiberchain::dem {

/// A body in contact. A wall has infinite radius and mass, a rigid one infinite modulus too.
struct ContactBody {
  double youngs_modulus, poisson_ratio;  ///< [Pa], [-]
  double radius, mass, inertia;          ///< [m], [kg], [kg m^2]
  int surface = 0;                       ///< its number in Domain::pairs
  ContactChoices contacts = {};          ///< of fibers at a wall
  bool smooth = false;                   ///< a segment of a smooth fiber with this radius

  bool operator==(const ContactBody&) const = default;
};

/// A sphere of the fiber that is not an end; an end sphere of half its mass meets others by the same law. Its
/// surface has the elasticity of these properties, else the fiber's (contact_elasticity).
ContactBody sphere_body(const Fiber& fiber, const ContactProperties& contacts);
/// A sphere of the chain with the elasticity that it has in all its contacts, or where those differ by pair
/// the fiber's.
ContactBody sphere_body(const Chain<3>& chain, const Domain& domain);
/// A wall with the elasticity of all walls.
ContactBody wall_body(const Domain& domain);
/// This wall.
ContactBody wall_body(const Domain& domain, const Wall& wall);
/// All walls, each kind once.
std::vector<ContactBody> wall_bodies(const Domain& domain);

/// The two as one.
EffectiveBody effective_body(const ContactBody& a, const ContactBody& b);

/// Two bodies as they touch.
struct ContactPair {
  ContactBody first, second;     ///< with the elasticity that spheres have there
  ContactProperties properties;  ///< of both surfaces

  EffectiveBody together() const { return effective_body(first, second); }
};
/// What their surfaces have comes before what the wall has, that before what all have.
ContactPair contact_pair(const Domain& domain, const ContactBody& first, const ContactBody& second);

/// Whether any bodies have rolling friction.
bool rolls(const Domain& domain);

/// Every pair of kinds of bodies that may meet, each once: a sphere of these chains, and another or a wall.
std::vector<ContactPair> contact_pairs(const Domain& domain, const std::vector<ContactBody>& spheres);

}  // namespace fiberchain::dem
