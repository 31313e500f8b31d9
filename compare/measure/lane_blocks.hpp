#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "dem/motion/kernels/chain_kernel.hpp"

namespace fiberchain::compare {

/// Indices of the same key, in blocks as wide as the lanes, to march side by side; the largest keys first.
/// What has no key is left out.
template <class Key>
std::vector<std::vector<std::size_t>> lane_blocks(const std::vector<std::optional<Key>>& keys) {
  std::map<Key, std::vector<std::size_t>, std::greater<>> alike;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i]) alike[*keys[i]].push_back(i);
  }
  const std::size_t width = dem::chain_kernel(dem::built_physics[0], dem::best_instruction_set()).width;
  std::vector<std::vector<std::size_t>> blocks;
  for (const auto& [key, members] : alike) {
    for (auto first = members.begin(); first != members.end();) {
      const auto end = first + std::min<std::ptrdiff_t>(width, members.end() - first);
      blocks.emplace_back(first, end);
      first = end;
    }
  }
  return blocks;
}

}  // namespace fiberchain::compare
