#pragma once

#include "dem/material/flat_loss.hpp"
#include "dem/scene/value_range.hpp"

// What values of materials may be, in scenes and in files of materials.
namespace fiberchain::dem {

inline constexpr ValueRange kPoissonRatio{.low = -1, .high = 0.5, .low_open = true};
inline constexpr ValueRange kLossFactor{.low = 0, .high = largest_flat_loss};

}  // namespace fiberchain::dem
