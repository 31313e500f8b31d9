#pragma once

namespace fiberchain::dem {

/// Doubles in a number type: 1, or the lanes of a vector.
template <class Real>
inline constexpr int lane_count = static_cast<int>(sizeof(Real) / sizeof(double));

}  // namespace fiberchain::dem
