#pragma once

namespace fiberchain::reference {

/// Free end of a cantilever under a tip load by linear Euler-Bernoulli theory, in SI units.
struct SmallDeflection {
  double deflection;  ///< P L^3 / (3 E I) [m] (the paper's Eq 12)
  double rotation;    ///< P L^2 / (2 E I) [rad]
};

/// Tip deflection over L at the dimensionless load P L^2 / (E I) (Eq 12): load / 3.
/// Any finite load; throws InvalidArgument otherwise.
double small_deflection_tip_y(double load);

/// Tip rotation [rad] at the dimensionless load P L^2 / (E I): load / 2.
double small_deflection_tip_angle(double load);

/// Tip deflection over L of the shearable (Timoshenko) cantilever, load (1/3 + 1/shear), where shear is
/// G A L^2 / (E I) and may be infinite. It is the tangent of the Reissner beam at zero load.
double timoshenko_tip_y(double load, double shear);

/// Eq 12 in SI units: force P [N], length L [m], modulus E [Pa], second moment of area I [m^4]. The force
/// may have either sign; the others are positive. Throws InvalidArgument.
SmallDeflection small_deflection(double force, double length, double modulus, double second_moment);

}  // namespace fiberchain::reference
