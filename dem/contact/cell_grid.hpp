#pragma once

#include <cstdint>
#include <vector>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// A box along the axes [m].
struct Box {
  Vec<double, 3> low, high;
};

/// Numbers 0, 1, ... in the cells of the places where they stand. What stands outside of the box counts for the cells at
/// its border; along periodic axes the box is the period.
class CellGrid {
 public:
  /// Cells no smaller than `edge` [m] and no more than some `most`. `period`: 0 along axes that are not periodic [m].
  CellGrid(const Box& box, const Vec<double, 3>& period, double edge, double most);

  /// The next number, at a finite place.
  void add(const Vec<double, 3>& place);
  void move(std::int32_t number, const Vec<double, 3>& to);

  /// visit(number) for all that stand in the cells at and next to a place, nearer than `edge` among them; until one
  /// returns false. Whether none did.
  template <class Visit>
  bool around(const Vec<double, 3>& place, const Visit& visit) const {
    const Cells x = cells(place, 0), y = cells(place, 1), z = cells(place, 2);
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
  /// What the cells next to a place along one axis add to a cell's index.
  struct Cells {
    int count;
    std::int32_t at[3];
  };
  int along(double x, int axis) const;
  Cells cells(const Vec<double, 3>& place, int axis) const;
  std::int32_t index(const Vec<double, 3>& place) const;

  Vec<double, 3> low_;
  bool periodic_[3];
  int count_[3];
  std::int32_t stride_[3];
  double inverse_edge_[3];
  std::vector<std::int32_t> head_, next_, cell_of_;  ///< chains of numbers in a cell; -1 ends
};

}  // namespace fiberchain::dem
