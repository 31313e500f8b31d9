#include "dem/contact/sorted_cells.hpp"

#include <numeric>

namespace fiberchain::dem {

void SortedCells::sort(const CellGeometry& cells, std::span<const std::int32_t> members, const SphereSet& all,
                       std::span<const Vec<double, 3>> positions, std::span<std::int32_t> slots) {
  cells_ = cells;
  const std::size_t n = members.size();
  cell_of_member_.resize(n), sphere_.resize(n), fiber_.resize(n);
  for (auto& numbers : x_) numbers.resize(n + lanes_beyond);
  radius_.resize(n + lanes_beyond);
  // counts, two cells further on; their sums, beginnings, one further on; filling makes these ends
  begin_.assign(static_cast<std::size_t>(cells.count()) + 2, 0);
  for (std::size_t m = 0; m < n; ++m) {
    cell_of_member_[m] = cells.index(positions[members[m]]);
    ++begin_[cell_of_member_[m] + 2];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  for (std::size_t m = 0; m < n; ++m) {
    const std::int32_t i = members[m], at = slots[i] = begin_[cell_of_member_[m] + 1]++;
    radius_[at] = all.radius[i];
    fiber_[at] = all.fiber[i];
    sphere_[at] = i;
    move(at, positions[i]);
  }
}

int SortedCells::runs_around(const Vec<double, 3>& place, SlotRange* runs) const {
  const CellGeometry::Near x = cells_.near(place, 0), y = cells_.near(place, 1), z = cells_.near(place, 2);
  // cells that follow one another along x are one run
  std::int32_t first[3], behind[3];
  int pieces = 0;
  for (int a = 0; a < x.count; ++a) {
    if (pieces == 0 || x.at[a] != behind[pieces - 1]) first[pieces++] = x.at[a];
    behind[pieces - 1] = x.at[a] + 1;
  }
  int count = 0;
  for (int c = 0; c < z.count; ++c) {
    for (int b = 0; b < y.count; ++b) {
      const std::int32_t row = y.at[b] + z.at[c];
      for (int k = 0; k < pieces; ++k) {
        const SlotRange run{begin_[row + first[k]], begin_[row + behind[k]]};
        runs[count] = run;  // no branch: whether a row is empty is not to be foreseen
        count += run.begin < run.end ? 1 : 0;
      }
    }
  }
  return count;
}

void SortedCells::runs_within(const Vec<double, 3>& place, double distance,
                              std::vector<SlotRange>& runs) const {
  runs.clear();
  cells_.rows_within(place, distance, [&](std::int32_t first, std::int32_t last) {
    const SlotRange run{begin_[first], begin_[last + 1]};
    if (run.begin < run.end) runs.push_back(run);
    return true;
  });
}

SortedSpheres SortedCells::view() const {
  return {{x_[0].data(), x_[1].data(), x_[2].data()}, radius_.data(), sphere_.data(), fiber_.data()};
}

}  // namespace fiberchain::dem
