#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ranges>
#include <vector>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A box along the axes [m].
struct Box {
  Vec<double, 3> low, high;
};

/// The least one around some points, at least one.
template <std::ranges::forward_range Points>
Box box_around(const Points& points) {
  Box box{*std::ranges::begin(points), *std::ranges::begin(points)};
  for (const Vec<double, 3>& x : points) {
    for (int c = 0; c < 3; ++c)
      box.low[c] = std::min(box.low[c], x[c]), box.high[c] = std::max(box.high[c], x[c]);
  }
  return box;
}

/// Cells that fill a box. What stands outside of it counts for the cells at its border; along periodic
/// axes the box is the period.
class CellGeometry {
 public:
  /// No smaller than `edge` [m] and no more than `most` in all. `period`: 0 along axes that are not periodic
  /// [m].
  CellGeometry(const Box& box, const Vec<double, 3>& period, double edge, double most);
  /// One cell that holds all.
  CellGeometry() = default;

  /// The cells at and next to a place along one axis, by what they add to a cell's index.
  struct Near {
    int count;
    std::int32_t at[3];
  };
  Near near(const Vec<double, 3>& place, int axis) const;
  /// visit(first, last) for rows of cells, by index, that together hold all that stands within `distance` [m]
  /// of a finite place; no cell twice; until one returns false. Whether none did.
  template <class Visit>
  bool rows_within(const Vec<double, 3>& place, double distance, const Visit& visit) const;
  /// Of the cell that holds a finite place.
  std::int32_t index(const Vec<double, 3>& place) const;
  std::int32_t count() const { return stride_[2] * count_[2]; }

 private:
  /// Cells along an axis; those beyond the last of a periodic one are its first again.
  struct Span {
    int first, count;
  };
  int along(double x, int axis) const;
  Span span(double x, double distance, int axis) const;
  /// Square of the distance along an axis to a cell of such a span [m^2].
  double squared_distance(double x, int axis, const Span& span, int cell) const;
  int wrapped(int cell, int axis) const { return cell < count_[axis] ? cell : cell - count_[axis]; }

  Vec<double, 3> low_{};
  bool periodic_[3]{};
  int count_[3]{1, 1, 1};
  std::int32_t stride_[3]{1, 1, 1};
  double edge_[3]{}, inverse_edge_[3]{};  ///< [m], [1/m]
};

template <class Visit>
bool CellGeometry::rows_within(const Vec<double, 3>& place, double distance, const Visit& visit) const {
  distance *= 1 + 1e-9;  // edges of cells are rounded
  const Span across[2] = {span(place[1], distance, 1), span(place[2], distance, 2)};
  for (int z = across[1].first; z < across[1].first + across[1].count; ++z) {
    const double left_of_z = distance * distance - squared_distance(place[2], 2, across[1], z);
    if (left_of_z < 0) continue;
    for (int y = across[0].first; y < across[0].first + across[0].count; ++y) {
      const double left = left_of_z - squared_distance(place[1], 1, across[0], y);
      if (left < 0) continue;
      const std::int32_t row = wrapped(y, 1) * stride_[1] + wrapped(z, 2) * stride_[2];
      const Span x = span(place[0], std::sqrt(left), 0);
      const int beyond = std::max(0, x.first + x.count - count_[0]);
      if (!visit(row + x.first, row + x.first + x.count - beyond - 1)) return false;
      if (beyond > 0 && !visit(row, row + beyond - 1)) return false;
    }
  }
  return true;
}

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
          if (!in_cell(x.at[a] + y.at[b] + z.at[c], visit)) return false;
        }
      }
    }
    return true;
  }

  /// The same for all that stand within `distance` [m] of a place, and others.
  template <class Visit>
  bool within(const Vec<double, 3>& place, double distance, const Visit& visit) const {
    return cells_.rows_within(place, distance, [&](std::int32_t first, std::int32_t last) {
      for (std::int32_t cell = first; cell <= last; ++cell) {
        if (!in_cell(cell, visit)) return false;
      }
      return true;
    });
  }

 private:
  template <class Visit>
  bool in_cell(std::int32_t cell, const Visit& visit) const {
    for (std::int32_t n = head_[cell]; n >= 0; n = next_[n]) {
      if (!visit(n)) return false;
    }
    return true;
  }

  CellGeometry cells_;
  std::vector<std::int32_t> head_, next_;  ///< chains of numbers in a cell; -1 ends
};

}  // namespace fiberchain::dem
