#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// A study's cases dealt to several machines.
namespace fiberchain::compare {

/// Part `index` of `count`.
struct Shard {
  int index = 1;  ///< from 1
  int count = 1;

  bool first() const { return index == 1; }
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Shards a study may be dealt to.
inline constexpr int most_shards = 100000;

/// "2/4" is the second of four.
/// @throws InputError naming `option`, the text and what is allowed
Shard parse_shard(std::string_view option, std::string_view text);

/// "2/4"
std::string to_string(const Shard& shard);

/// The shard's own of `count` cases, ascending from 0: every N-th, so that all get cheap and dear ones of a
/// sweep whose cost rises. Every case falls to one shard, whatever machine deals.
std::vector<std::size_t> dealt(const Shard& shard, std::size_t count);

/// The same where costs are known: the dearest first, each to the shard that has the least to do.
std::vector<std::size_t> dealt_by_cost(const Shard& shard, const std::vector<double>& costs);

}  // namespace fiberchain::compare
