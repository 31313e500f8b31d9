#pragma once

#include "dem/math/vec.hpp"

// The values that a contact law takes and gives: templates on the number type, a double or as many contacts
// side by side as a Real has lanes.
namespace fiberchain::dem {

/// Two bodies that touch. The second one is pushed along `normal`.
template <class Real>
struct TouchingPair {
  Vec<Real, 3> normal;    ///< from the first to the second
  Real overlap;           ///< > 0 [m]; of laws that act beyond touch also minus the gap
  Vec<Real, 3> velocity;  ///< of the second's surface against the first's at the contact [m/s]
  Vec<Real, 3> spin;      ///< of the second against the first [1/s]
  Vec<Real, 3> mean_spin;
};

template <class Real>
struct ContactAction {
  Vec<Real, 3> force;   ///< on the first body, at the contact [N]
  Vec<Real, 3> moment;  ///< of rolling friction on the first body; minus that on the second [N m]
};

/// Energy [J] that each mechanism has dissipated.
template <class Real>
struct ContactAccount {
  Real normal_dashpot, sliding, rolling;
};

/// A contact about some overlap, for the time step.
struct ContactStiffness {
  double normal, tangential;                  ///< [N/m]
  double normal_dashpot, tangential_dashpot;  ///< [N s/m]
};

template <class Real>
Vec<Real, 3> tangential(const Vec<Real, 3>& u, const Vec<Real, 3>& normal) {
  return u - dot(u, normal) * normal;
}

/// A contact law that wants a work of adhesion.
template <class Law>
concept Adheres = requires {
  Law::adheres;
};

}  // namespace fiberchain::dem
