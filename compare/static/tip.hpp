#pragma once

#include <vector>

#include "compare/study/nan.hpp"
#include "dem/equilibrium/dynamic_relaxation.hpp"
#include "dem/equilibrium/stability.hpp"
#include "reference/tip_state.hpp"

// The free end of a cantilevered chain under a dead load, by each of the two ways to its equilibrium.
namespace fiberchain::compare {

inline reference::TipState operator-(const reference::TipState& a, const reference::TipState& b) {
  return {a.y - b.y, a.x - b.x, a.angle - b.angle};
}

inline reference::TipState operator*(double s, const reference::TipState& a) {
  return {s * a.y, s * a.x, s * a.angle};
}

/// What the chain itself says, before it is compared. Lengths over L.
struct ChainTip {
  reference::TipState tip{nan, nan, nan};
  reference::TipState solved{nan, nan, nan};  ///< equilibrium of the total form
  reference::TipState history{0, 0, 0};       ///< incremental form at vanishing step - total form
  reference::TipState time_step{0, 0, 0};     ///< at the step taken - at vanishing step
  reference::TipState leftover{0, 0, 0};      ///< where it stopped - at rest
  double residual = nan;                      ///< Imbalance::moment
  dem::Stability stability = dem::Stability::undecided;
  double steps = 0;       ///< of time
  double run_time = nan;  ///< [s]; a lane's share of its block
  long iterations = 0;    ///< of Newton
};

/// By Newton. dimension 2 or 3.
ChainTip solve_tip(int dimension, const dem::Fiber& fiber, double load);

/// By marching, the loads side by side in lanes; the incremental form twice, to know what the step does.
std::vector<ChainTip> march_tips(int dimension, const dem::Fiber& fiber, const std::vector<double>& loads,
                                 const dem::RelaxOptions& options);

/// Departure of the deflection from P L^3 / (3 E I) at vanishing load, from the chain's tangent at rest.
double small_load_departure(const dem::Fiber& fiber);

}  // namespace fiberchain::compare
