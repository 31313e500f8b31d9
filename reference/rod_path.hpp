#pragma once

#include <functional>
#include <vector>

#include "reference/spatial_rod.hpp"

// Paths of equilibria of a rod in space by pseudo-arc-length continuation in what is unknown at its begin and
// the load factor (E. Riks, Int. J. Solids Struct. 15 (1979) 529-551), their limit points and the loads at
// which they branch.
namespace fiberchain::reference {

struct RodPathOptions {
  double first_step = 0.02;  ///< of arc length: load factor, places over L, turns, forces over the largest
  double largest_step = 0.1;
  int points = 400;                                                                     ///< most of them
  std::function<bool(const RodEquilibrium&)> ends = [](const auto&) { return false; };  ///< after this one
};

/// Equilibria from a known one on, at first toward larger load factors. Throws NoConvergence.
std::vector<RodEquilibrium> rod_path(const RodProblem& problem, const RodEquilibrium& start,
                                     const RodPathOptions& options = {});

/// Equilibria of a path at which the load factor turns back, refined to 1e-12 of the arc length's slope.
std::vector<RodEquilibrium> rod_limit_points(const RodProblem& problem,
                                             const std::vector<RodEquilibrium>& path);

/// Which motions a critical load belongs to.
enum class RodMotion { in_plane, out_of_plane };

/// Load factor between two at which a planar equilibrium branches: a zero of the determinant. The equilibria
/// are followed from rest. Throws NoConvergence where it has one sign at both.
double rod_critical_factor(const RodProblem& problem, double low, double high, RodMotion motion);

}  // namespace fiberchain::reference
