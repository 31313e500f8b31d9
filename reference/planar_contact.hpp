#pragma once

#include <array>
#include <span>

#include "reference/two_spheres.hpp"

namespace fiberchain::reference::detail {

/// Displacement of the second body against the first, the velocities and spins of both, the tangential
/// spring. Lengths in Hertz's largest overlap, velocities in the closing speed, masses in m*.
struct PlanarState {
  enum : std::size_t { x, y, u1, v1, w1, u2, v2, w2, spring, size };
};
using PlanarNumbers = std::array<double, PlanarState::size>;

enum class ContactMode { sticks, slides_forward, slides_backward };

/// The contact of two_spheres.hpp in those units. The force on the first body is minus the normal force along
/// the normal and the tangential force along the tangent, which is the normal turned by +90 degrees.
struct PlanarContact {
  double stiffness, tangential, damping, tangential_damping, friction;
  std::array<double, 2> inverse_mass, inverse_inertia;
  double reach;                 ///< R_1 + R_2, of a wall R_1
  std::array<double, 2> share;  ///< arms over the distance
  bool wall;                    ///< the normal keeps its direction

  void rates(std::span<const double> state, ContactMode mode, std::span<double> derivative) const;
  double overlap(std::span<const double> state) const;
  double normal_velocity(std::span<const double> state) const;  ///< - d(overlap)/dt
  /// Positive while the bodies push on each other.
  double lasting(std::span<const double> state) const;
  /// Positive while the mode is right. Sticking: what is left to the limit. Sliding: how fast the force that
  /// a stuck spring would come to rises above the limit.
  double holding(std::span<const double> state, ContactMode mode) const;
  /// T, and the mode that follows when the present one no longer holds.
  double spring(std::span<const double> state, ContactMode mode) const;
  ContactMode next(std::span<const double> state, ContactMode mode) const;
  /// At the first touch, where all forces vanish, by the leading terms.
  ContactMode first(std::span<const double> state) const;

 private:
  struct AtContact;
  AtContact at_contact(std::span<const double> state) const;
  double dashpot(const AtContact& l) const;
  double softening(const AtContact& l) const;
  double stick_rate(const AtContact& l, double spring) const;
  double slide_rate(const AtContact& l, double spring, double tangential_force) const;
};

}  // namespace fiberchain::reference::detail
