#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A box along the axes [m].
struct Box {
  Vec<double, 3> low, high;
};

/// The least one around some points, at least one.
Box box_around(std::span<const Vec<double, 3>> points);

/// Cells that fill a box. What stands outside of it counts for the cells at its border; along periodic
/// axes the box is the period.
class CellGeometry {
 public:
  /// No smaller than `edge` [m] and no more than `most` in all. `period`: 0 along axes that are not periodic
  /// [m].
  CellGeometry(const Box& box, const Vec<double, 3>& period, double edge, double most);

  /// The cells at and next to a place along one axis, by what they add to a cell's index.
  struct Near {
    int count;
    std::int32_t at[3];
  };
  Near near(const Vec<double, 3>& place, int axis) const;
  /// Of the cell that holds a finite place.
  std::int32_t index(const Vec<double, 3>& place) const;
  std::int32_t count() const { return stride_[2] * count_[2]; }

 private:
  int along(double x, int axis) const;

  Vec<double, 3> low_;
  bool periodic_[3];
  int count_[3];
  std::int32_t stride_[3];
  double inverse_edge_[3];
};

/// Numbers 0, 1, ... in the cells of the points where they stand; more can be added.
class LinkedCellList {
 public:
  explicit LinkedCellList(const CellGeometry& cells) : cells_(cells), head_(cells.count(), -1) {}

  /// The next number, at a finite place.
  void add(const Vec<double, 3>& place);

  /// visit(number) for all that stand in the cells at and next to a place, nearer than an edge among them;
  /// until one returns false. Whether none did.
  template <class Visit>
  bool around(const Vec<double, 3>& place, const Visit& visit) const {
    const CellGeometry::Near x = cells_.near(place, 0), y = cells_.near(place, 1), z = cells_.near(place, 2);
    for (int c = 0; c < z.count; ++c) {
      for (int b = 0; b < y.count; ++b) {
        for (int a = 0; a < x.count; ++a) {
          for (std::int32_t n = head_[x.at[a] + y.at[b] + z.at[c]]; n >= 0; n = next_[n]) {
            if (!visit(n)) return false;
          }
        }
      }
    }
    return true;
  }

 private:
  CellGeometry cells_;
  std::vector<std::int32_t> head_, next_;  ///< chains of numbers in a cell; -1 ends
};

}  // namespace fiberchain::dem
