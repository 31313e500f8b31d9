#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace fiberchain::reference {

// A rod in space with a round cross section (published flat ones, too, have two E I). Its sections turn by R'
// = R [kappa]_x along the undeformed arc, m = R diag(GJ, EI, EI) (kappa - kappa_0) and n = R diag(EA, GA, GA)
// (v - e_x) are the moment and the force that the part beyond puts on a section, r' = R v, and
//   n' = -w,  m' = -r' x n,  w the load per undeformed length.
// Cosserat's rod as Reissner and Simo have it; Kirchhoff's where EA and GA are infinite. The chain's
// corrected bond converges to the rod with its EA and without shear, the paper's to the one with EA and GA.
// (S. S. Antman, Nonlinear Problems of Elasticity, 2nd ed., Springer 2005, chapter 8; J. C. Simo, Comput.
// Meth. Appl. Mech. Eng. 49 (1985) 55-70.)

using SpaceVector = std::array<double, 3>;

/// A part of a rod with the same curvature all along.
struct RodSegment {
  double length;                 ///< along the undeformed arc [m]
  SpaceVector rest_curvature{};  ///< kappa_0 in the section's frame: twist, then about y and z [1/m]
  double corner = 0;             ///< turn of the tangent about the section's z where the part begins [rad]
  SpaceVector joint_force{};     ///< force of fixed direction where the part begins, per load factor [N]
};

struct SpatialRod {
  std::vector<RodSegment> segments;  ///< from the begin, where the first tangent is e_x before its corner
  double bending;                    ///< E I [N m^2]
  double torsion;                    ///< G J [N m^2]
  double axial;                      ///< E A [N], infinity allowed
  double shear = std::numeric_limits<double>::infinity();  ///< G A [N], infinity allowed
  double sideways = 0;  ///< E I about the section's y where that differs from E I about z; 0: it does not
};

/// What the rod bears. Loads that follow are given in the frame of the section they act on.
struct RodLoads {
  SpaceVector force{};             ///< on the end, of fixed direction [N]
  SpaceVector moment{};            ///< on the end, of fixed direction [N m]
  SpaceVector weight{};            ///< all along, of fixed direction [N/m]
  SpaceVector following_force{};   ///< on the end [N]
  SpaceVector following_weight{};  ///< all along [N/m]
  SpaceVector begin_force{};       ///< on the begin, of fixed direction [N]
  SpaceVector begin_moment{};      ///< on the begin, of fixed direction [N m]
};

/// How an end may turn.
enum class RodJoint {
  clamped,  ///< not at all
  hinge,    ///< about one axis
  ball      ///< in any way
};

/// What holds an end: it may move along those of the axes in space that are not held.
struct RodEnd {
  std::array<bool, 3> held{true, true, true};
  RodJoint joint = RodJoint::clamped;
  SpaceVector hinge_axis{0, 0, 1};
  SpaceVector moved{};   ///< where a held end is taken to, per load factor [m]
  SpaceVector turned{};  ///< turn of a clamped end about a fixed axis, per load factor [rad]
};

inline constexpr RodEnd free_rod_end{.held = {false, false, false}, .joint = RodJoint::ball};

/// Place and frame of a section: the rotation vector that turns the axes in space to it.
struct RodPose {
  SpaceVector position{};  ///< [m]
  SpaceVector rotation{};  ///< [rad]
};

struct RodProblem {
  SpatialRod rod;
  RodEnd begin{};                                  ///< at the origin at rest
  RodEnd end = free_rod_end;                       ///< where the rest shape has it, unless
  std::optional<RodPose> end_pose = std::nullopt;  ///< it is held here
  RodLoads steady{};                               ///< at every load factor
  RodLoads varied{};                               ///< times the load factor
  bool planar = false;                             ///< moves in the plane of x and y alone
};

/// State of a section.
struct RodSection {
  SpaceVector position;               ///< [m]
  std::array<double, 4> orientation;  ///< quaternion x, y, z, w
  SpaceVector force;                  ///< n [N]
  SpaceVector moment;                 ///< m [N m]
};

/// An equilibrium: equations integrated by GSL's Prince-Dormand pair with local errors of 1e-14 + 1e-13 of
/// the component, conditions at the ends met within 1e-11 of L and of the largest force and moment (at least
/// EI / L^2 and EI / L).
struct RodEquilibrium {
  double factor;                     ///< of the varied loads and motions
  std::vector<RodSection> sections;  ///< where the segments begin, then the end
  double residual;                   ///< of the conditions at the ends, scaled
  double slope;  ///< of the factor along the path, 0 at a limit point (paths only, otherwise 1)
  /// Of the conditions' derivatives by what is unknown at the begin, for motions in the plane of x and y and
  /// out of it, meaningful where rod and loads lie in it: zero at a critical point. Scaled.
  double in_plane, out_of_plane;
};

/// Equilibrium at a load factor by Newton's method from a section at the begin.
/// Throws InvalidArgument for a rod that is none, NoConvergence.
RodEquilibrium solve_rod(const RodProblem& problem, double factor, const RodSection& begin);

/// Equilibrium at a load factor, followed from factor 0 where the rod is at rest (no steady loads), in
/// `steps` steps that halve where Newton's method fails.
RodEquilibrium follow_rod(const RodProblem& problem, double factor = 1, int steps = 10);

/// Section at the begin of the rod at rest.
RodSection rod_at_rest();

/// Sections at `points` + 1 places even along the arc of an equilibrium.
std::vector<RodSection> rod_shape(const RodProblem& problem, const RodEquilibrium& equilibrium, int points);

/// Where the free end of a clamped rod comes to, the loads raised in `load_steps` parts from rest. [m]
SpaceVector spatial_rod_end(const SpatialRod& rod, const RodLoads& loads, int load_steps = 10);

}  // namespace fiberchain::reference
