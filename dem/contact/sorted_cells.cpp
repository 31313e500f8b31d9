#include "dem/contact/sorted_cells.hpp"

namespace fiberchain::dem {

SortedCells::SortedCells(const CellGeometry& cells, std::span<const Vec<double, 3>> positions,
                         std::span<const double> radius, std::span<const std::int32_t> fiber)
    : cells_(cells), first_place_(positions.begin(), positions.end()), begin_(cells.count() + 1, 0) {
  const auto n = static_cast<std::int32_t>(positions.size());
  std::vector<std::int32_t> cell(n);
  for (std::int32_t i = 0; i < n; ++i) {
    cell[i] = cells.index(positions[i]);
    ++begin_[cell[i] + 1];
  }
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  slot_.resize(n), sphere_.resize(n), fiber_.resize(n);
  for (auto& numbers : x_) numbers.resize(n + lanes_beyond);
  radius_.resize(n + lanes_beyond);
  std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t at = slot_[i] = next[cell[i]]++;
    radius_[at] = radius[i];
    fiber_[at] = fiber[i];
    sphere_[at] = i;
    move(i, positions[i]);
  }
}

void SortedCells::move(std::int32_t sphere, const Vec<double, 3>& to) {
  for (int c = 0; c < 3; ++c) x_[c][slot_[sphere]] = to[c];
}

int SortedCells::runs_around(const Vec<double, 3>& place, SlotRange* runs) const {
  const CellGeometry::Near x = cells_.near(place, 0), y = cells_.near(place, 1), z = cells_.near(place, 2);
  int count = 0;
  for (int c = 0; c < z.count; ++c) {
    for (int b = 0; b < y.count; ++b) {
      const std::int32_t row = y.at[b] + z.at[c];
      for (int a = 0; a < x.count; ++a) {
        const std::int32_t cell = x.at[a] + row;
        const bool goes_on = a > 0 && x.at[a] == x.at[a - 1] + 1;
        if (!goes_on) runs[count++] = {begin_[cell], begin_[cell]};
        runs[count - 1].end = begin_[cell + 1];
      }
    }
  }
  return count;
}

SortedSpheres SortedCells::view() const {
  return {{x_[0].data(), x_[1].data(), x_[2].data()}, radius_.data(), sphere_.data(), fiber_.data()};
}

}  // namespace fiberchain::dem
