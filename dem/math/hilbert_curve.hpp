#pragma once

#include <array>
#include <cstdint>

namespace fiberchain::dem {

/// Bits of a coordinate on the curve.
inline constexpr int hilbert_bits = 16;

/// Where a cell of a cube of 2^hilbert_bits cells a side lies on the Hilbert curve through all of them: cells
/// that follow one another share a face. Skilling, AIP Conf. Proc. 707 (2004) 381.
std::uint64_t hilbert_index(std::array<std::uint32_t, 3> cell);

}  // namespace fiberchain::dem
