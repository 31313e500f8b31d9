#pragma once

#include "dem/contact/kernels/contact_kernel.hpp"

namespace fiberchain::dem {

/// Place of a body's nodes among the slots. A body has the number of its first node.
struct BodyNodes {
  const std::int32_t *before, *end, *behind;  ///< of each slot (SegmentNodes); of a sphere itself
};

/// What the loops over segments have beside that of spheres, and their memory between the passes over a part.
struct SegmentView : ContactView {
  BodyNodes nodes;
  std::int32_t pair_count;  ///< of the pairs, which are in order of their first, then of their second body
  std::int32_t *near, *begun, *ended;  ///< inner pairs; capacity for all and lanes_beyond
  std::int32_t* source;  ///< of each begun one: the number whose history it goes on with, 0 of none
  double* places;        ///< SegmentContact of each touching pair, number by number: `stride` of each
  std::ptrdiff_t stride;
};

/// A wall and the contacts that segments have with its ridges now; slots are their bodies.
struct RidgeView : WallView {
  std::int32_t touching;  ///< without pads, which touch nothing
  const double* places;   ///< along the segments
  const double* shares;   ///< of whole contacts
};

}  // namespace fiberchain::dem
