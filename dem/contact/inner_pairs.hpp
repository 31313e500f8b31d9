#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dem/contact/kernels/contact_kernel.hpp"

namespace fiberchain::dem {

/// Pairs pruned from a part's neighbor pairs: those that touch or may touch before the next pruning. Only
/// their distances are worked out at every step.
struct InnerPairList {
  std::vector<std::int32_t> pair;                    ///< number among the neighbor pairs
  std::vector<std::int32_t> first, second, contact;  ///< as of PairList
  std::vector<std::uint8_t> touches;
  std::int32_t count = 0;         ///< padded to whole vectors
  double displacement_since = 0;  ///< by which other pairs may have closed in since the pruning [m]
  bool stale = true;              ///< to be pruned before it is used

  /// Of the first `pairs` neighbor pairs of the view, whole vectors of them, those with a gap below `cutoff`
  /// [m] or in contact. Pads are pairs of the slots `pad` and `pad + 1`.
  void prune(const ContactView& view, std::int32_t pairs, double cutoff, const ContactKernel& kernel,
             std::int32_t pad);
  /// Pairs with a second sphere from `end` on, which is of a later part.
  std::size_t halo_count(std::int32_t end) const;
  InnerPairs view() { return {pair.data(), first.data(), second.data(), contact.data(), touches.data()}; }

 private:
  void reserve(std::size_t numbers);

  std::int32_t found_ = 0;  ///< without pads
};

}  // namespace fiberchain::dem
