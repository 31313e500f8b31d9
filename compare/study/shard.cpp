#include "compare/study/shard.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "compare/study/errors.hpp"
#include "compare/study/jobs.hpp"
#include "dem/files/numbers.hpp"

namespace fiberchain::compare {

Shard parse_shard(std::string_view option, std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) {
    const auto index = dem::parse_integer(text.substr(0, slash)),
               count = dem::parse_integer(text.substr(slash + 1));
    if (index && count && *index >= 1 && *index <= *count && *count <= most_shards)
      return {static_cast<int>(*index), static_cast<int>(*count)};
  }
  throw InputError(fmt::format("{}: '{}' is not allowed: give I/N, part I of N, with 1 <= I <= N <= {}",
                               option, text, most_shards));
}

std::string to_string(const Shard& shard) { return fmt::format("{}/{}", shard.index, shard.count); }

std::vector<std::size_t> dealt(const Shard& shard, std::size_t count) {
  std::vector<std::size_t> own;
  for (auto n = static_cast<std::size_t>(shard.index - 1); n < count;
       n += static_cast<std::size_t>(shard.count))
    own.push_back(n);
  return own;
}

std::vector<std::size_t> dealt_by_cost(const Shard& shard, const std::vector<double>& costs) {
  std::vector<double> loads(static_cast<std::size_t>(shard.count), 0.0);
  std::vector<std::size_t> own;
  for (const std::size_t n : dearest_first(costs)) {
    const auto least = std::ranges::min_element(loads);
    *least += costs[n];
    if (least - loads.begin() == shard.index - 1) own.push_back(n);
  }
  std::ranges::sort(own);
  return own;
}

}  // namespace fiberchain::compare
