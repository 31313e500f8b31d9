#include "dem/contact/inner_pairs.hpp"

#include <algorithm>

namespace fiberchain::dem {
namespace {

/// Neighbor pairs looked at between two checks of the capacity: whole vectors.
constexpr std::int32_t kPairsAtOnce = 1024;

}  // namespace

void InnerPairList::reserve(std::size_t numbers) {
  const std::size_t with_rest = numbers + numbers / 8;
  for (std::vector<std::int32_t>* list : {&pair, &first, &second, &contact}) {
    if (list->size() < numbers) list->resize(with_rest);
  }
  if (touches.size() < numbers) touches.resize(with_rest);
}

void InnerPairList::prune(const ContactView& all, std::int32_t pairs, double cutoff,
                          const ContactKernel& kernel, std::int32_t pad) {
  found_ = 0;
  for (std::int32_t begin = 0; begin < pairs; begin += kPairsAtOnce) {
    reserve(static_cast<std::size_t>(found_) + kPairsAtOnce + lanes_beyond);
    found_ = kernel.prune(all, begin, std::min(begin + kPairsAtOnce, pairs), cutoff, view(), found_);
  }
  for (count = found_; count % kernel.width != 0; ++count) {
    pair[count] = contact[count] = 0;
    first[count] = pad, second[count] = pad + 1;
    touches[count] = 0;
  }
  stale = false, displacement_since = 0;
}

std::size_t InnerPairList::halo_count(std::int32_t end) const {
  return std::count_if(second.begin(), second.begin() + found_, [&](std::int32_t j) { return j >= end; });
}

}  // namespace fiberchain::dem
