#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dem/contact/contact_history.hpp"
#include "dem/contact/neighbor_list.hpp"

namespace fiberchain::dem {

/// Neighbor pairs whose first sphere is of one part, in order, padded to whole vectors.
struct PairList {
  std::vector<std::int32_t> first, second;  ///< spheres
  std::vector<std::int32_t> contact;        ///< number in the histories; 0 of pairs that do not touch
  std::size_t count = 0;                    ///< without pads
  std::vector<int> reached;                 ///< the other parts with a second sphere, rising
  std::size_t across = 0;                   ///< pairs with a second sphere of another part

  void clear();
  /// After the neighbor list has been built or updated: pairs of a rebuilt sphere are those found now, all
  /// others stay. A pair that stays keeps its contact; histories of the others are given back. Whole vectors
  /// of `width`; pads are pairs of the slots `pad` and `pad + 1`. `scratch` keeps its memory between calls.
  void update(const NeighborList& list, int part, ContactHistories& histories, int width, std::int32_t pad,
              PairList& scratch);

 private:
  void find_reached(const Partition& parts, int own);
};

}  // namespace fiberchain::dem
