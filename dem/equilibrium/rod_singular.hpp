#pragma once

#include "dem/equilibrium/rod_examine.hpp"

namespace fiberchain::dem {

/// Appends to path.singular what lies between two stations, the second `step` after the first, in order.
void find_singular_points(const RodContext& context, const RodStation& from, const RodStation& to,
                          double step, RodPath& path);

}  // namespace fiberchain::dem
