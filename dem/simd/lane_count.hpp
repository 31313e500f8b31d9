#pragma once

#include <cstddef>

namespace fiberchain::dem {

/// Doubles in a number type: 1, or the lanes of a vector.
template <class Real>
inline constexpr int lane_count = static_cast<int>(sizeof(Real) / sizeof(double));

/// A count padded to whole vectors of `width` lanes.
constexpr std::size_t whole_vectors(std::size_t count, int width) {
  return (count + width - 1) / width * width;
}

}  // namespace fiberchain::dem
