#pragma once

#include <span>
#include <vector>

#include "dem/contact/kernels/contact_kernel.hpp"
#include "dem/contact/linked_cell_list.hpp"

namespace fiberchain::dem {

/// Spheres in the order of the cells where they stood first: those near a place are a few runs of consecutive
/// ones.
class SortedCells {
 public:
  static constexpr int most_runs = 27;

  /// The arrays behind the view stay where they are.
  SortedCells(const CellGeometry& cells, std::span<const Vec<double, 3>> positions,
              std::span<const double> radius, std::span<const std::int32_t> fiber);

  /// A sphere moves, not far: it stays in the cell where it stood first.
  void move(std::int32_t sphere, const Vec<double, 3>& to);
  double distance_from_first(std::int32_t sphere, const Vec<double, 3>& place) const {
    return norm(place - first_place_[sphere]);
  }

  std::int32_t cell_of(const Vec<double, 3>& place) const { return cells_.index(place); }
  /// Of the cells at and next to a place; how many.
  int runs_around(const Vec<double, 3>& place, SlotRange* runs) const;
  SortedSpheres view() const;

 private:
  CellGeometry cells_;
  std::vector<Vec<double, 3>> first_place_;
  std::vector<std::int32_t> begin_, slot_, sphere_, fiber_;
  std::vector<double> x_[3], radius_;
};

}  // namespace fiberchain::dem
