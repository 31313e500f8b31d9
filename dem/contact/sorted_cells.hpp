#pragma once

#include <span>
#include <vector>

#include "dem/contact/kernels/contact_kernel.hpp"
#include "dem/contact/linked_cell_list.hpp"

namespace fiberchain::dem {

/// Spheres by number.
struct SphereSet {
  std::vector<double> radius;       ///< [m]
  std::vector<std::int32_t> fiber;  ///< neighbors along a fiber have consecutive numbers and do not contact
  Vec<double, 3> period;            ///< [m]; 0: not periodic
};

/// Some spheres in the order of the cells where they stood first: those near a place are a few runs of
/// consecutive slots.
class SortedCells {
 public:
  static constexpr int most_runs = 27;

  /// Sorts the spheres `members` of all. `slots`, of all, gets theirs. Until the next call the arrays behind
  /// the view stay where they are; memory is kept from one to the next.
  void sort(const CellGeometry& cells, std::span<const std::int32_t> members, const SphereSet& all,
            std::span<const Vec<double, 3>> positions, std::span<std::int32_t> slots);

  /// The sphere of a slot moves, not far: it stays in the cell where it stood first.
  void move(std::int32_t slot, const Vec<double, 3>& to) {
    for (int c = 0; c < 3; ++c) x_[c][slot] = to[c];
  }

  std::int32_t cell_of(const Vec<double, 3>& place) const { return cells_.index(place); }
  /// Of the cells at and next to a place, none of them empty; how many.
  int runs_around(const Vec<double, 3>& place, SlotRange* runs) const;
  /// Of all spheres that stood first within `distance` [m] of a place, and of others near them.
  void runs_within(const Vec<double, 3>& place, double distance, std::vector<SlotRange>& runs) const;
  SortedSpheres view() const;

 private:
  CellGeometry cells_;
  std::vector<std::int32_t> begin_;           ///< of each cell; the end of the last
  std::vector<std::int32_t> cell_of_member_;  ///< scratch of sort()
  std::vector<std::int32_t> sphere_, fiber_;
  std::vector<double> x_[3], radius_;
};

}  // namespace fiberchain::dem
