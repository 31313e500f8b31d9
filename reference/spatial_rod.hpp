#pragma once

#include <array>
#include <vector>

namespace fiberchain::reference {

// A rod in space with a round cross section, clamped at one end: Cosserat's rod without shear. Its sections
// turn by R' = R [kappa]_x along the undeformed arc, m = R diag(GJ, EI, EI) (kappa - kappa_0) is the moment
// that the part beyond puts on a section, and r' = (1 + N / EA) R e_x with N = n . R e_x. An end force F, an
// end moment M and a load w per length that keep their directions give n(s) = F + (L - s) w, m' = -r' x n,
// m(L) = M.
// (S. S. Antman, Nonlinear Problems of Elasticity, 2nd ed., Springer 2005, chapter 8.)

using SpaceVector = std::array<double, 3>;

/// A part of a rod with the same curvature all along.
struct RodSegment {
  double length;                 ///< along the undeformed arc [m]
  SpaceVector rest_curvature{};  ///< kappa_0 in the section's frame: twist, then about y and z [1/m]
  double corner = 0;             ///< turn of the tangent about the section's z where the part begins [rad]
};

struct SpatialRod {
  std::vector<RodSegment> segments;  ///< from the clamp, where the first tangent is e_x before its corner
  double bending;                    ///< E I [N m^2]
  double torsion;                    ///< G J [N m^2]
  double axial;                      ///< E A [N], infinity allowed
};

/// What the rod bears, all of it of fixed direction.
struct RodLoads {
  SpaceVector force{};   ///< on the free end [N]
  SpaceVector moment{};  ///< on the free end [N m]
  SpaceVector weight{};  ///< all along [N/m]
};

/// Where the free end comes to: by shooting for the moment at the clamp with GSL's hybrid method, the loads
/// raised in `load_steps` parts from rest. [m]
/// Throws InvalidArgument for lengths and stiffnesses that are not positive, NoConvergence.
SpaceVector spatial_rod_end(const SpatialRod& rod, const RodLoads& loads, int load_steps = 10);

}  // namespace fiberchain::reference
