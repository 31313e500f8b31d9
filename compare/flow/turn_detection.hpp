#pragma once

#include <vector>

#include "compare/flow/history.hpp"

// How a fiber turns in the x-y plane, from its directions and their rates of change.
namespace fiberchain::compare {

/// Angle phi of the directions from y toward x (tan phi = p_x/p_y), unwrapped: moments no more than a quarter
/// turn apart.
std::vector<double> phases(const std::vector<FlowMoment>& moments);

/// Moments at which phi has gone 1, 2, 3 ... half turns from where it started [s]; between samples by the
/// cubic through both angles and rates.
std::vector<double> half_turns(const std::vector<FlowMoment>& moments);

/// Twice the mean time of a half turn [s]: a fiber does not know head from tail. The first, in which the
/// bonds take up their load, is left out where there are more. NaN without a half turn.
double orbit_period(const std::vector<FlowMoment>& moments);

}  // namespace fiberchain::compare
