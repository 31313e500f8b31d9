#pragma once

namespace fiberchain::reference {

// Hertz's contact of two cylinders whose axes cross (Johnson, Contact Mechanics (1985), sections 4.1
// and 4.2): an ellipse, by complete elliptic integrals.

/// k of F = k delta^(3/2) [N/m^1.5] of cylinders with these radii [m] under this angle [rad], E* [Pa]. Throws
/// InvalidArgument unless radii and modulus are positive and 0 < angle <= pi/2.
double crossed_cylinder_stiffness(double modulus, double radius_1, double radius_2, double angle);

/// Of any two bodies by the curvatures of their gap, A x^2 + B y^2, 0 < A <= B [1/m].
double elliptic_contact_stiffness(double modulus, double A, double B);

}  // namespace fiberchain::reference
