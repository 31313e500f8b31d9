#pragma once

#include "reference/two_spheres.hpp"

namespace fiberchain::reference {

// Coulomb friction on rigid spheres: closed forms by impulse and momentum.

/// A solid sphere that comes down obliquely on a wall, or relative motion of two equal spheres. The surface
/// slips over the wall at tangential + R spin.
struct ObliqueMotion {
  double tangential;    ///< velocity of the center along the wall [m/s]
  double surface_spin;  ///< R omega [m/s], its sense such that it adds to the slip
};

/// What a contact that ends with restitution e leaves of it.
struct FrictionImpact {
  ObliqueMotion after;
  bool slides;  ///< to the end; otherwise friction has brought the slip to zero: it rolls
};

/// A contact rigid along the wall: it slides through, losing 7/2 mu (1 + e) v_n of the slip, or is left
/// rolling. (An elastic one slides through alike, but can turn the slip around where this one rolls: Maw,
/// Barber & Fawcett, Wear 38 (1976) 101.) v_n > 0 is the speed of approach. Throws InvalidArgument unless v_n
/// > 0, mu >= 0, 0 <= e <= 1.
FrictionImpact friction_impact(const ObliqueMotion& before, double approach, double friction,
                               double restitution);

/// Tangential restitution of the slip when it slides through: 1 - 7/2 mu (1 + e) v_n / slip.
double sliding_slip_restitution(double slip, double approach, double friction, double restitution);

/// Motions after a contact of two bodies (the second may be a wall) that slides through: the impulse m* (1 +
/// e) v_n along the line of centers, mu times that across. Arms are the radii, as of bodies that do not
/// deform; those of spheres that overlap are shorter by it. Throws InvalidArgument unless the bodies
/// approach, slip, mu >= 0 and 0 <= e
/// <= 1.
std::array<PlanarMotion, 2> sliding_impact(const ElasticBody& first, const ElasticBody& second,
                                           double friction, double restitution,
                                           const PlanarMotion& first_motion,
                                           const PlanarMotion& second_motion);

/// A solid sphere released at rest on a plane inclined by `angle` [rad].
struct SphereOnSlope {
  bool slides;                  ///< tan(angle) > 7/2 mu
  double acceleration;          ///< of the center: 5/7 g sin(angle) rolling, g (sin - mu cos) sliding [m/s^2]
  double surface_acceleration;  ///< R times that of the spin: the same rolling, 5/2 mu g cos sliding [m/s^2]
};

/// Throws InvalidArgument unless g > 0, mu >= 0 and the angle lies between 0 and pi/2.
SphereOnSlope sphere_on_slope(double angle, double friction, double gravity);

/// Deceleration of a solid sphere that rolls on a level plane against a moment mu_r R F_n: 5/7 mu_r g
/// [m/s^2], while the friction it needs, 5/7 mu_r, stays below mu.
double rolling_deceleration(double rolling_friction, double gravity);

}  // namespace fiberchain::reference
