#include "dem/contact/wall_neighbors.hpp"

#include <utility>

#include "dem/contact/walk_rebuilt.hpp"
#include "dem/simd/lane_count.hpp"

namespace fiberchain::dem {

void WallNeighbors::update(const std::vector<std::int32_t>& rebuilt,
                           const std::function<bool(std::int32_t)>& is_near, ContactHistories& histories,
                           int width, std::int32_t pad, WallNeighbors& next) {
  next.slots.clear(), next.contact.clear();
  const auto append = [&](std::int32_t slot, std::int32_t number) {
    next.slots.push_back(slot);
    next.contact.push_back(number);
  };
  walk_rebuilt(
      std::span(slots).first(count), rebuilt, [&](std::size_t p) { append(slots[p], contact[p]); },
      [&](std::int32_t i, std::optional<std::size_t> was) {
        const std::int32_t number = was ? contact[*was] : 0;
        if (is_near(i)) {
          append(i, number);
        } else if (number != 0) {
          histories.give_back(number);
        }
      });
  next.count = next.slots.size();
  next.slots.resize(whole_vectors(next.count, width), pad);
  next.contact.resize(next.slots.size(), 0);
  std::swap(*this, next);
}

}  // namespace fiberchain::dem
