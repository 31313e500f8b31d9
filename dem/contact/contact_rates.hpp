#pragma once

#include "dem/contact/contact_body.hpp"

namespace fiberchain::dem {

/// How stiff and how damped contacts make a sphere, for the largest stable step.
struct ContactRates {
  double stiffness;  ///< largest eigenvalue of stiffness over inertia [1/s^2]
  double dashpots;   ///< of normal dashpots and half the tangential ones over inertia [1/s]

  /// Part of what stability allows that contacts use up at a step: dt^2 stiffness / 4 + dt dashpots. The mode
  /// that grows first changes sign every step. There normal dashpots extrapolated to the middle of their kick
  /// (HertzMindlin::Parameters::extrapolation = 1/2) see 3/2 + 1/2 = 2 times the velocity of the step before,
  /// the tangential ones see it once: stability needs 4 M - dt^2 K - 4 dt C_n - 2 dt C_t positive definite.
  double used(double dt) const { return 0.25 * dt * dt * stiffness + dt * dashpots; }
};

/// Of `neighbors` contacts about a sphere, in all directions alike, each pressed in by `overlap` [m], with
/// the stiffness and the dashpots of the law: the larger of translation, (K_n + 2 K_t) / 3 a contact over m*,
/// and rolling all in one sense, 2/3 K_t a contact over J* / R^2 = 2/5 m*; at least two that face each other.
/// The dashpots alike.
ContactRates contact_rates(const ContactBody& a, const ContactBody& b, const ContactProperties& properties,
                           double overlap, int neighbors);

}  // namespace fiberchain::dem
