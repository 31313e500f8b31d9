#pragma once

#include <optional>

namespace fiberchain::dem {

struct ContactLaw;  // dem/contact/contact_law.hpp

/// Surface properties of bodies in contact.
struct ContactProperties {
  double restitution = 1;                     ///< normal coefficient of restitution, 0 < e <= 1
  double friction = 0;                        ///< Coulomb's mu
  double rolling_friction = 0;                ///< mu_r: a moment of at most mu_r R* F_n against rolling
  std::optional<double> youngs_modulus = {};  ///< of the fibers' surface [Pa]; left out: each fiber's own
  std::optional<double> poisson_ratio = {};   ///< likewise [-]
  const ContactLaw* law = nullptr;  ///< the law they are parameters of; null: the first of ContactLaws
  double work_of_adhesion = 0;      ///< w, of laws that adhere: by which surfaces hold each other [J/m^2]
};

/// What some contacts have in place of what all have.
struct ContactChoices {
  std::optional<double> restitution = {}, friction = {}, rolling_friction = {};
  std::optional<double> youngs_modulus = {}, poisson_ratio = {};  ///< of the fibers' surface

  bool operator==(const ContactChoices&) const = default;
};

/// The properties with these choices.
inline ContactProperties with(ContactProperties contacts, const ContactChoices& choices) {
  contacts.restitution = choices.restitution.value_or(contacts.restitution);
  contacts.friction = choices.friction.value_or(contacts.friction);
  contacts.rolling_friction = choices.rolling_friction.value_or(contacts.rolling_friction);
  if (choices.youngs_modulus) contacts.youngs_modulus = choices.youngs_modulus;
  if (choices.poisson_ratio) contacts.poisson_ratio = choices.poisson_ratio;
  return contacts;
}

/// What two surfaces have, in place of what all have and of what is a wall's.
struct SurfacePair {
  int first = 0, second = 0;  ///< their numbers (Chain::surface, Wall::surface), in any order
  ContactChoices contacts;
};

}  // namespace fiberchain::dem
