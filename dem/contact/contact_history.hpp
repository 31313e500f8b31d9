#pragma once

#include <cstdint>
#include <vector>

#include "dem/simd/lane_array.hpp"
#include "dem/simd/storage_layout.hpp"

namespace fiberchain::dem {

/// What a contact remembers, by sphere numbers, to be written to a file. second < 0: wall -1 - second.
struct SavedContact {
  std::int64_t first, second;
  double spring[3];     ///< on the first
  double sqrt_overlap, normal_velocity, rolling_power;  ///< as ContactHistory
  double work[contact_account_size] = {};  ///< accounted only
};

/// The same of many contacts: a row each, which has the contact's number. Number 0 is nobody's: pairs that do not touch
/// have it.
struct ContactHistories {
  LaneArray rows, work;
  std::vector<std::int32_t> free;  ///< numbers; the first `free_count` are free
  std::int32_t free_count = 0;
  bool accounted = false;

  /// All are free.
  void reset();
  /// At least so many are free.
  void reserve(std::size_t numbers);
  std::int32_t take() { return free[--free_count]; }
  void give_back(std::int32_t number) { free[free_count++] = number; }

  SavedContact at(std::int32_t number, std::int64_t first, std::int64_t second) const;
  void put(std::int32_t number, const SavedContact& contact);
};

}  // namespace fiberchain::dem
