#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "dem/contact/contact_history.hpp"

namespace fiberchain::dem {

/// Spheres of a part near one wall, by rising number, padded to whole vectors. Of a mesh the contacts of the
/// last step alone, a sphere as often as it has some (mesh_neighbors.hpp).
struct WallNeighbors {
  std::vector<std::int32_t> slots, contact;  ///< number in the histories; 0 of spheres that do not touch
  std::size_t count = 0;                     ///< without pads
  std::vector<std::int32_t> features = {};   ///< of a mesh: what of it is touched, rising for each sphere
  std::vector<double> nearest = {};          ///< likewise, as WallView::nearest

  /// Which contact of its sphere with the wall it is, for its key.
  std::int32_t key_slot(std::size_t n) const { return features.empty() ? 0 : features[n]; }

  /// Of the part's `rebuilt` spheres (by rising number) those are neighbors for which `is_near` says so; all
  /// others stay as they were. A sphere that stays keeps its contact; histories of the others are given back.
  /// Whole vectors of `width`, pads are the slot `pad`. `scratch` keeps its memory between calls.
  void update(const std::vector<std::int32_t>& rebuilt, const std::function<bool(std::int32_t)>& is_near,
              ContactHistories& histories, int width, std::int32_t pad, WallNeighbors& scratch);
};

}  // namespace fiberchain::dem
