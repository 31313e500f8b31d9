#pragma once

#include <cstdint>
#include <vector>

#include "dem/motion/lanes/lane_array.hpp"
#include "dem/sphere_rows.hpp"

namespace fiberchain::dem {

/// What a contact remembers, by sphere numbers, to be written to a file. second < 0: wall -1 - second.
struct KeptContact {
  std::int64_t first, second;
  double spring[3];     ///< on the first
  double root, opening, rolling_power;  ///< as ContactHistory
  double work[work_numbers] = {};  ///< booked only
};

/// The same of many contacts: a row each, which has the contact's number. Number 0 is nobody's: pairs that do not touch
/// have it.
struct ContactMemory {
  LaneArray rows, work;
  std::vector<std::int32_t> free;  ///< numbers; the first `free_count` are free
  std::int32_t free_count = 0;
  bool booked = false;

  /// All are free.
  void reset();
  /// At least so many are free.
  void make_room(std::size_t numbers);
  std::int32_t take() { return free[--free_count]; }
  void give_back(std::int32_t number) { free[free_count++] = number; }

  KeptContact at(std::int32_t number, std::int64_t first, std::int64_t second) const;
  void put(std::int32_t number, const KeptContact& contact);
};

}  // namespace fiberchain::dem
