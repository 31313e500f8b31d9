#pragma once

#include <cstddef>

#include "reference/tip_state.hpp"

namespace fiberchain::reference {

// Reissner's extensible, shearable cantilever under a dead tip load P: the continuum limit of the chain.
// theta is the rotation of the section; in its frame the dead load gives the normal force
// N = P sin(theta) and the shear force Q = P cos(theta), so stretch N/EA and shear Q/GA, and
//   E I theta'' = -P x',  x' = (1 + N/EA) cos(theta) - (Q/GA) sin(theta),
//                         y' = (1 + N/EA) sin(theta) + (Q/GA) cos(theta).
// (E. Reissner, On one-dimensional finite-strain beam theory: the plane problem, ZAMP 23 (1972) 795-804.)

/// Largest load P L^2 / (E I) accepted.
inline constexpr double max_reissner_load = 1e4;

/// Free end for load = P L^2/(E I), 0 to max_reissner_load, axial = E A L^2/(E I) and
/// shear = G A L^2/(E I), both greater than zero; infinity makes the beam inextensible or unshearable
/// (both: the Elastica). By shooting from the free end with the logarithm of the angle's distance from the
/// rest angle of an endless beam as unknown. Throws InvalidArgument, NoConvergence.
TipState reissner_tip(double load, double axial, double shear);

/// Free end (y and x over L) of a beam given in SI units: bending stiffness E I [N m^2], axial stiffness
/// E A [N], shear stiffness G A [N] (corrections included), force P [N], length L [m].
TipState reissner_cantilever(double bending, double axial, double shear, double force, double length);

/// Shape at n >= 2 stations equally spaced in undeformed arc length, by the same shooting.
BeamShape reissner_shape(double load, double axial, double shear, std::size_t n);

}  // namespace fiberchain::reference
