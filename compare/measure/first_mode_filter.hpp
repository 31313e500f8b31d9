#pragma once

#include "compare/measure/peaks.hpp"

namespace fiberchain::compare {

/// Periods of the first mode on each side that a filtered sample is made from.
inline constexpr double filter_reach = 3;

/// The first mode's part of a lightly damped motion: samples weighted by cos^8 over six of its periods times
/// cosines of its frequency [rad/s] and of three times it, which a large swing has too. A decaying mode
/// passes with its decay and frequency unchanged; mode 2 of a cantilever, 6.3 times as fast, is 1e-10 of what
/// it was. Filtered samples begin half a period after the first that has both sides, so that with a release
/// at rest the first peak is number 4, and end three periods before the history does. Samples must be evenly
/// spaced.
/// @throws InputError for a history of less than eight periods
TipHistory first_mode_part(const TipHistory& history, double frequency);

}  // namespace fiberchain::compare
