#pragma once

#include "dem/contact/kernels/segment_view.hpp"

namespace fiberchain::dem {

/// The loops of smooth fibers, those that take a SegmentView.
struct SegmentKernel {
  decltype(ContactKernel::prune) prune;
  decltype(ContactKernel::pairs) pairs;
  void (*ridges)(const ContactView&, const RidgeView&, ContactTask&);
};

inline constexpr int segment_combinations = 4;
/// Number of a kernel in the tables: with rolling friction or not, accounted or not.
constexpr int segment_index(const ContactPhysics& p) { return (p.rolling ? 1 : 0) + (p.accounted ? 2 : 0); }

/// Kernels of one instruction set.
template <InstructionSet set>
struct SegmentKernels {
  static const SegmentKernel* table();
};

}  // namespace fiberchain::dem
