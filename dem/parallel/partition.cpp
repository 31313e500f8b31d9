#include "dem/parallel/partition.hpp"

#include <algorithm>
#include <utility>

namespace fiberchain::dem {
namespace {

/// Enough for threads to share, few enough to be numbered.
constexpr std::int64_t kFewest = 16, kMost = 512;

}  // namespace

Partition::Partition(std::vector<std::int32_t> begins) : begins_(std::move(begins)) {
  for (int k = 0; k < count(); ++k) part_.resize(end(k), static_cast<std::uint16_t>(k));
}

PartDependencies::PartDependencies(std::vector<std::vector<int>> reached)
    : reached_(std::move(reached)), dependencies_(reached_.size()) {
  for (int k = 0; k < count(); ++k) {
    for (const int later : reached_[k]) dependencies_[later].push_back(k);
  }
}

Partition even_partition(std::int32_t spheres, int count) {
  std::vector<std::int32_t> begins;
  for (std::int64_t k = 0; k <= count; ++k) begins.push_back(static_cast<std::int32_t>(spheres * k / count));
  return Partition(std::move(begins));
}

Partition cache_sized_partition(const std::vector<std::int32_t>& ends) {
  const std::int64_t spheres = ends.back(), count = std::clamp(spheres / cache_sized_part, kFewest, kMost);
  std::vector<std::int32_t> begins{0};
  for (const std::int32_t end : ends) {
    if (static_cast<std::int64_t>(end) * count >= spheres * static_cast<std::int64_t>(begins.size()))
      begins.push_back(end);
  }
  return Partition(std::move(begins));
}

}  // namespace fiberchain::dem
