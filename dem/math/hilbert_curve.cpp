#include "dem/math/hilbert_curve.hpp"

namespace fiberchain::dem {
namespace {

using Cell = std::array<std::uint32_t, 3>;

/// Undoes the turns of the cubes that hold the cell, from the largest to the smallest.
void unturn(Cell& x) {
  for (std::uint32_t side = 1u << (hilbert_bits - 1); side > 1; side >>= 1) {
    const std::uint32_t below = side - 1;
    for (std::uint32_t& c : x) {
      if ((c & side) != 0) {
        x[0] ^= below;  // mirrored
      } else {
        const std::uint32_t differ = (x[0] ^ c) & below;  // two axes exchanged
        x[0] ^= differ, c ^= differ;
      }
    }
  }
}

void gray_encode(Cell& x) {
  for (int a = 1; a < 3; ++a) x[a] ^= x[a - 1];
  std::uint32_t flips = 0;
  for (std::uint32_t side = 1u << (hilbert_bits - 1); side > 1; side >>= 1) {
    if ((x[2] & side) != 0) flips ^= side - 1;
  }
  for (std::uint32_t& c : x) c ^= flips;
}

}  // namespace

std::uint64_t hilbert_index(Cell cell) {
  unturn(cell);
  gray_encode(cell);
  std::uint64_t index = 0;
  for (int bit = hilbert_bits - 1; bit >= 0; --bit) {
    for (const std::uint32_t c : cell) index = index << 1 | (c >> bit & 1u);
  }
  return index;
}

}  // namespace fiberchain::dem
