#pragma once

#include "dem/equilibrium/rod_step.hpp"

// What is known at a point of a path besides where it is: stability, the way on, how near to singular.
namespace fiberchain::dem {

/// A point of the path with the way on.
struct RodStation {
  RodState state;
  RodPoint point;
  RodDirection tangent;  ///< per unit of what leads the path
};

/// The equation that leads from a station over `step` of its control.
PathEquation path_equation(const RodContext& context, const RodDirection& tangent, double step);

/// The station at a state; `before` is the way that led there.
RodStation station_at(const RodContext& context, const RodState& state, const RodDirection& before);

/// The station that the path has `step` after `from`; nothing where Newton fails.
std::optional<RodStation> station_after(const RodContext& context, const RodStation& from, double step,
                                        int& iterations);

/// Eigenvalue of the tangent that is nearest to zero, over E I / L as in stability.hpp, and its vector.
struct NearestMode {
  double eigenvalue;
  ChainVector<3> mode;  ///< largest component 1 [L, rad], its sum toward +y, or +z, or +x
};
NearestMode nearest_mode(const RodContext& context, const RodState& state);

}  // namespace fiberchain::dem
