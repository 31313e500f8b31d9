#pragma once

#include "dem/contact/lanes/gather.hpp"
#include "dem/contact/view.hpp"

// Who is near a sphere: distances to as many spheres at a time as there are lanes.
namespace fiberchain::dem {

template <bool periodic, class Real>
int near_spheres(const SortedSpheres& all, const SlotRange* ranges, int count, const Asking& own, std::int32_t* found) {
  constexpr int lanes = lane_count<Real>;
  const Real reach_of_own(own.radius + all.skin);
  int n = 0;
  for (const SlotRange* range = ranges; range != ranges + count; ++range) {
    for (std::int32_t k = range->begin; k < range->end; k += lanes) {
      Real squared(0.0);
      for (int c = 0; c < 3; ++c) {
        Real r = load_lanes<Real>(all.x[c] + k) - Real(own.x[c]);
        if constexpr (periodic) r = r - Real(all.period[c]) * nearest(r * Real(all.inverse_period[c]));
        squared = squared + r * r;
      }
      const Real reach = reach_of_own + load_lanes<Real>(all.radius + k);
      unsigned near = less_mask(squared, reach * reach);
      if (range->end - k < lanes) near &= (1u << (range->end - k)) - 1u;
      for (; near != 0; near &= near - 1) {
        const std::int32_t at = k + __builtin_ctz(near), other = all.sphere[at];
        if (other > own.sphere + 1 || (other == own.sphere + 1 && all.fiber[at] != own.fiber)) found[n++] = other;
      }
    }
  }
  return n;
}

}  // namespace fiberchain::dem
