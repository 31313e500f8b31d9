#pragma once

#include <optional>

#include "dem/equilibrium/rod_path.hpp"
#include "dem/equilibrium/rod_supports.hpp"

// One point of a rod's path: Newton's method on equilibrium and one equation that says where on the path.
namespace fiberchain::dem {

struct RodState {
  Poses<3> poses;
  double factor = 0;  ///< load factor
};

/// A way to go from a state.
struct RodDirection {
  ChainVector<3> motion;
  double factor = 0;

  RodDirection& operator*=(double by);
};

/// What stays the same along a path.
struct RodContext {
  const RodProblem& problem;
  Poses<3> start;  ///< from where supports count
  const RodPathOptions& options;
};

/// row . motion + factor_row * (change of the load factor) = target, summed over Newton's steps since the
/// point before; measured exactly where it is a displacement.
struct PathEquation {
  ChainVector<3> row;  ///< empty: none
  double factor_row = 0;
  double target = 0;
  std::optional<RodProbe> probe = std::nullopt;
};

/// Mean over spheres of displacements / L and rotations, and the load factor's: the path's measure.
double inner_product(const RodContext& context, const RodDirection& a, const RodDirection& b);

/// a's row of that measure.
PathEquation along(const RodContext& context, const RodDirection& a, double target);

/// What answers to the equation's row with `amount`, the forces out of balance and `missing` of the equation.
RodDirection bordered_solve(const RodSystem& system, const PathEquation& equation, double missing,
                            bool with_unbalanced);

void advance(const RodContext& context, RodState& state, const RodDirection& direction);

/// The point of the path where the equation holds, from the predictor on; nothing where Newton fails.
std::optional<RodState> rod_newton(const RodContext& context, const RodState& from,
                                   const PathEquation& equation, const RodDirection& predictor,
                                   int& iterations);

double probe_displacement(const RodContext& context, const Poses<3>& poses);

}  // namespace fiberchain::dem
