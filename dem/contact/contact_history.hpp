#pragma once

#include <cstdint>
#include <vector>

#include "dem/contact/contact_key.hpp"
#include "dem/simd/lane_array.hpp"
#include "dem/simd/storage_layout.hpp"

namespace fiberchain::dem {

/// A contact and its history, to be kept where lists change or written to a file.
struct SavedContact {
  ContactKey key;
  double history[contact_history_size] = {};  ///< the law's History, then zeros
  double work[contact_account_size] = {};     ///< accounted only
};

/// Where the history of a contact is.
struct ContactPlace {
  ContactKey key;
  std::int32_t part, number;
};

/// The same of many contacts: a row each, which has the contact's number. Number 0 is nobody's: pairs that do
/// not touch have it.
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

  SavedContact at(std::int32_t number, const ContactKey& key) const;
  void put(std::int32_t number, const SavedContact& contact);
};

}  // namespace fiberchain::dem
