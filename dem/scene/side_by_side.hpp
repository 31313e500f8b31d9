#pragma once

#include "dem/scene/packing_scene.hpp"

namespace fiberchain::dem {

/// So many copies of a scene side by side along x, in one room: fibers from files, between planes whose first
/// side walls stand across x. What costs are measured on as it grows.
inline PackingScene side_by_side(const PackingScene& scene, int copies) {
  PackingScene wide = scene;
  const double length = scene.scene_box.high[0] - scene.scene_box.low[0];
  for (PackingFiberKind& kind : wide.kinds) {
    const std::vector<FiberStart> once = kind.starts;
    for (int n = 1; n < copies; ++n) {
      for (FiberStart start : once) {
        start.position[0] += n * length;
        kind.starts.push_back(start);
      }
    }
  }
  wide.scene_box.high[0] += (copies - 1) * length;
  for (Wall& wall : wide.domain.walls) {
    if (auto* plane = wall.shape.get_if<Plane>(); plane != nullptr && plane->normal[0] < 0)
      plane->point[0] += (copies - 1) * length;
  }
  return wide;
}

}  // namespace fiberchain::dem
