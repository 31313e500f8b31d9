#pragma once

#include <vector>

#include "dem/vibration/release.hpp"

namespace fiberchain::compare {

/// Free end's positions over L at increasing times [s] after the release, by GSL's Prince-Dormand 8(9) pair
/// at this local tolerance on the chain's own equations: springs of the total form and dashpots of dem's bond
/// law, sphere 0 clamped. Shares with dem's integrators the law of one bond and nothing else. Throws
/// reference::NoConvergence.
std::vector<dem::Vec<double, 2>> tip_path_by_runge_kutta(const dem::Release<2>& release,
                                                         const std::vector<double>& times, double tolerance);

}  // namespace fiberchain::compare
