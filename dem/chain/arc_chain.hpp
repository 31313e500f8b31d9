#pragma once

#include "dem/chain/chain.hpp"

namespace fiberchain::dem {

/// Stress-free arc from the origin, in the x-y plane, turning from x towards y by the fiber's rest angle a
/// bond; straight for 0. Throws InvalidInput for a fiber that makes no sense, and unless the arc ends before
/// its ends meet: |rest_angle| (r_f + 1) <= 2 pi, and before every other sphere touches: |rest_angle| <= 2 pi
/// / 3.
Chain<3> arc_chain(const Fiber& fiber);

}  // namespace fiberchain::dem
