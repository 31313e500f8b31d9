#pragma once

#include <cstdint>
#include <vector>

#include "dem/motion/lanes/lane_array.hpp"
#include "dem/sphere_rows.hpp"

namespace fiberchain::dem {

/// What a touching pair remembers, by sphere numbers, to be written to a file. second < 0: wall -1 - second.
struct KeptContact {
  std::int64_t first, second;
  double spring[3];  ///< on the first
  double root, opening;  ///< as ContactHistory
  double work[work_numbers] = {};  ///< booked only
};

/// The same of many pairs, row by row: what contact loops read and write.
struct ContactMemory {
  LaneArray rows, work;
  std::vector<std::uint8_t> touched;
  bool booked = false;

  /// That many pairs that do not touch.
  void reset(std::size_t size);
  /// Pair i here is pair `p` of `from`.
  void carry(std::size_t i, const ContactMemory& from, std::size_t p);
  KeptContact at(std::size_t i, std::int64_t first, std::int64_t second) const;
  void put(std::size_t i, const KeptContact& contact);
};

}  // namespace fiberchain::dem
