#pragma once

#include "dem/contact/kernels/contact_kernel.hpp"
#include "dem/contact/periodic_box.hpp"
#include "dem/simd/gather.hpp"

// Neighbors of a sphere: distances to as many spheres at a time as there are lanes.
namespace fiberchain::dem {

template <bool periodic, class Real>
std::int32_t query_neighbors(const SortedSpheres& all, const SlotRange* runs, int count,
                             const NeighborQuery& own, std::int32_t* found) {
  constexpr int lanes = lane_count<Real>;
  const Real reach_of_own(own.reach);
  std::int32_t n = 0;
  for (const SlotRange* run = runs; run != runs + count; ++run) {
    for (std::int32_t k = run->begin; k < run->end; k += lanes) {
      Vec<Real, 3> r;
      for (int c = 0; c < 3; ++c) r[c] = load_lanes<Real>(all.x[c] + k) - Real(own.x[c]);
      if constexpr (periodic) r = nearest_image(own.periods, r);
      const Real reach = reach_of_own + load_lanes<Real>(all.radius + k);
      unsigned near = less_mask(dot(r, r), reach * reach);
      if (run->end - k < lanes) near &= (1u << (run->end - k)) - 1u;
      for (; near != 0; near &= near - 1) {
        const std::int32_t at = k + __builtin_ctz(near), apart = all.sphere[at] - own.sphere;
        if (apart == 0 || ((apart == 1 || apart == -1) && all.fiber[at] == own.fiber)) continue;
        found[n++] = all.sphere[at];
      }
    }
  }
  return n;
}

}  // namespace fiberchain::dem
