#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "dem/equilibrium/rod_problem.hpp"
#include "dem/equilibrium/stability.hpp"
#include "dem/model/interrupted.hpp"

// Equilibria of a rod along a path: Newton's method with the exact tangent, led by the load factor, a
// displacement or the arc length, through limit points; singular points found, named and left by a branch.
namespace fiberchain::dem {

enum class RodControl {
  load,          ///< the load factor goes up to the end; fails at a limit point
  displacement,  ///< one sphere's displacement goes up to its end; fails where it snaps
  arc_length     ///< goes through limit points
};

constexpr std::string_view name(RodControl control) {
  constexpr std::string_view names[] = {"load", "displacement", "arc-length"};
  return names[static_cast<int>(control)];
}

/// A displacement of one sphere along a direction from where it starts.
struct RodProbe {
  int sphere = 0;
  Vec<double, 3> direction{};  ///< unit vector
};

struct RodPathOptions {
  RodControl control = RodControl::arc_length;
  int points = 50;              ///< about so many steps to the end; the first step is 1 / points of the way
  int most_points = 400;        ///< path points after which an arc-length path stops
  double end_factor = 1;        ///< load factor where the path ends, reached exactly (load, arc_length)
  double end_displacement = 0;  ///< of the probe, where the path ends: exactly (displacement), or at the
                                ///< first point beyond it (arc_length, if not 0) [m]
  RodProbe probe = {};
  double largest_step = 0;   ///< arc length; 0: 4 / points of the straight way. The measure is the root mean
                             ///< square over spheres of displacement / L and rotation, and the load factor
  double tolerance = 1e-10;  ///< Newton step (displacement / L, rotation [rad]) as SolveOptions::tolerance
  int max_iterations = 15;
  double smallest_step = 1e-7;       ///< part of the first step below which the path is given up
  bool find_singular = true;         ///< looks for limit points and bifurcations between path points
  double singular_tolerance = 1e-9;  ///< part of a step between its bounds that ends the search, too
  StopRequest asked_to_stop = {};    ///< asked before every solution with a tangent
};

struct RodPoint {
  double factor = 0;  ///< load factor [-]
  double arc = 0;     ///< arc length since the start of the path [-]
  Poses<3> poses = {};
  double elastic_energy = 0;  ///< [J]
  double work = 0;            ///< of loads and prescribed supports since the path's start, trapezoids [J]
  double probe = 0;           ///< displacement of the probe [m]
  int iterations = 0;         ///< of Newton
  int negative = 0;           ///< negative eigenvalues of the tangent (of its symmetric part)
  Stability stability = Stability::undecided;  ///< undecided where the loads have no potential: a divergence
                                               ///< is found as a singular point, flutter is not
};

enum class SingularKind {
  limit_point,  ///< the load factor turns
  bifurcation   ///< another path crosses
};
constexpr std::string_view name(SingularKind kind) {
  return kind == SingularKind::limit_point ? "limit point" : "bifurcation";
}

struct SingularPoint {
  SingularKind kind = SingularKind::limit_point;
  int after = 0;     ///< index of the path point before it
  int crossing = 0;  ///< change of the number of negative eigenvalues over it
  RodPoint point = {};
  ChainVector<3> mode = {};  ///< null vector, largest component 1 [L, rad]
};

struct RodPath {
  std::vector<RodPoint> points;  ///< the first at load factor 0
  std::vector<SingularPoint> singular;
  int newton_iterations = 0;  ///< in all, refinement of singular points included
  int halvings = 0;           ///< of steps that failed
};

/// The path from load factor 0. Throws InvalidInput as check() and for options that make no sense,
/// NoConvergence when a step falls below the smallest, the message tells the load factor; Interrupted when
/// asked to stop, as the other two.
RodPath trace_rod(const RodProblem& problem, const RodPathOptions& options = {});

/// From a bifurcation onto the branch that crosses there, the way of `sign` times the mode, `amplitude` the
/// mode's largest component [L, rad] at the first point. Loads, start and options are those of the path.
RodPath trace_branch(const RodProblem& problem, const SingularPoint& bifurcation, int sign, double amplitude,
                     const RodPathOptions& options = {});

/// The equilibrium at a load factor, by load steps as large as converge (arc length where they do not, the
/// first time that the factor is reached). Does not look at singular points on the way.
RodPoint solve_rod(const RodProblem& problem, double factor = 1, const RodPathOptions& options = {});

}  // namespace fiberchain::dem
