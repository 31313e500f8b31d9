#pragma once

#include <string>

#include "dem/run/samples.hpp"

// How deep contacts are pressed, in words: their laws hold for small overlaps.
namespace fiberchain::dem {

/// Overlaps over the smaller radius beyond which is warned: the deepest of an impact, the mean at rest.
inline constexpr double impact_overlap_limit = 0.1, rest_overlap_limit = 0.01;

/// Whether what presses contacts now is what lies on them: less energy moves than they store.
bool presses_at_rest(const RunMoment& moment);

/// Warning of an overlap since the start beyond the limit of impacts; "" where there is none.
std::string impact_warning(const RunMoment& moment);

/// Likewise of the mean overlap at rest.
std::string rest_warning(const RunMoment& moment);

/// What single spheres come to that meet at a speed [m/s], with a warning beyond the limit of impacts.
std::string expected_impact_in_words(double speed, double overlap);

}  // namespace fiberchain::dem
