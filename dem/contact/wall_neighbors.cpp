#include "dem/contact/wall_neighbors.hpp"

#include <utility>

#include "dem/simd/lane_count.hpp"

namespace fiberchain::dem {

void WallNeighbors::update(const std::vector<std::int32_t>& rebuilt,
                           const std::function<bool(std::int32_t)>& is_near, ContactHistories& histories,
                           int width, std::int32_t pad, WallNeighbors& next) {
  next.slots.clear(), next.contact.clear();
  std::size_t p = 0;
  const auto append = [&](std::int32_t slot, std::int32_t number) {
    next.slots.push_back(slot);
    next.contact.push_back(number);
  };
  for (const std::int32_t i : rebuilt) {
    for (; p < count && slots[p] < i; ++p) append(slots[p], contact[p]);
    const bool was = p < count && slots[p] == i;
    if (is_near(i)) {
      append(i, was ? contact[p] : 0);
    } else if (was && contact[p] != 0) {
      histories.give_back(contact[p]);
    }
    p += was ? 1 : 0;
  }
  for (; p < count; ++p) append(slots[p], contact[p]);
  next.count = next.slots.size();
  next.slots.resize(whole_vectors(next.count, width), pad);
  next.contact.resize(next.slots.size(), 0);
  std::swap(*this, next);
}

}  // namespace fiberchain::dem
