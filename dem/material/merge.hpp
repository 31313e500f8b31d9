#pragma once

#include "dem/model/prony_series.hpp"

namespace fiberchain::dem {

/// The branches of both beside one spring, K / K_inf = 1 + sum of both sums: longest time first, those of
/// equal times as one, those of no strength left out. Throws InvalidInput as check() does.
PronySeries merge(const PronySeries& a, const PronySeries& b);

/// merge() with nothing.
PronySeries tidy(const PronySeries& series);

}  // namespace fiberchain::dem
