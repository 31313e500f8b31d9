#pragma once

#include <array>
#include <cstdint>

namespace fiberchain::dem {

/// Which number of a random sequence.
struct Draw {
  std::uint64_t number;  ///< of what is drawn for, as a fiber
  std::uint64_t attempt;
  std::uint64_t block;  ///< of four numbers
};

/// Four numbers uniform in (0, 1], a function of seed and place alone (Philox 4x64, Salmon, Moraes, Dror &
/// Shaw, SC 2011): the same whatever was drawn before or by whom.
std::array<double, 4> uniform_numbers(std::uint64_t seed, const Draw& draw);

}  // namespace fiberchain::dem
