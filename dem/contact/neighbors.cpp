#include "dem/contact/neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "dem/errors.hpp"

namespace fiberchain::dem {
namespace {

/// Cells no smaller than `edge`; along each axis.
struct Grid {
  Vec<double, 3> low;
  double inverse[3];
  int count[3];
  int order[3];  ///< axes, fastest first
  bool periodic[3];

  int cell_along(int axis, double x) const {
    const int c = static_cast<int>(std::floor((x - low[axis]) * inverse[axis]));
    if (!periodic[axis]) return std::clamp(c, 0, count[axis] - 1);
    return ((c % count[axis]) + count[axis]) % count[axis];
  }

  int index(const int* cell) const {
    return cell[order[0]] + count[order[0]] * (cell[order[1]] + count[order[1]] * cell[order[2]]);
  }

  bool inside(const int* cell) const {
    bool all = true;
    for (int c = 0; c < 3; ++c) all = all && cell[c] > 0 && cell[c] < count[c] - 1;
    return all;
  }

  int cells() const { return count[0] * count[1] * count[2]; }
};

Grid grid_for(const SphereSet& spheres, double edge) {
  Vec<double, 3> low = spheres.position[0], high = low;
  for (const auto& x : spheres.position) {
    for (int c = 0; c < 3; ++c) {
      if (!std::isfinite(x[c])) throw InvalidInput("a sphere's position is not finite");
      low[c] = std::min(low[c], x[c]);
      high[c] = std::max(high[c], x[c]);
    }
  }
  Grid grid{low, {}, {}, {0, 1, 2}, {}};
  // a fiber that flew off must not make the grid larger than the memory
  const double most = std::cbrt(64.0 * static_cast<double>(spheres.position.size()) + 64);
  for (int c = 0; c < 3; ++c) {
    grid.periodic[c] = spheres.period[c] > 0;
    const double length = grid.periodic[c] ? spheres.period[c] : high[c] - low[c];
    grid.count[c] = std::max(1, static_cast<int>(std::min(std::floor(length / edge), grid.periodic[c] ? 1e4 : 4 * most)));
    if (grid.periodic[c]) {
      grid.low[c] = 0;
      if (grid.count[c] < 3) {
        throw InvalidInput(fmt::format("period = {:g} m is not allowed: it must be at least {:g} m, three times what spheres "
                                       "see of each other", spheres.period[c], 3 * edge));
      }
    }
    grid.inverse[c] = length > 0 ? grid.count[c] / length : 0;
  }
  std::stable_sort(grid.order, grid.order + 3, [&](int a, int b) { return grid.count[a] < grid.count[b]; });
  return grid;
}

/// Where the runs of the neighbors of a cell begin, seen from it, for cells that are no boundary of a periodic side: three
/// cells along the fastest axis each.
struct Stencil {
  int run[9];

  explicit Stencil(const Grid& grid) {
    const int row = grid.count[grid.order[0]], layer = row * grid.count[grid.order[1]];
    for (int k = 0; k < 9; ++k) run[k] = (k / 3 - 1) * layer + (k % 3 - 1) * row - 1;
  }
};

/// Slots of the cells next to and at `cell`, in nine runs or, across a periodic side, a few more.
class Neighborhood {
 public:
  Neighborhood(const Stencil& stencil, const std::vector<std::int32_t>& cell_begin, int cell) {
    for (const int run : stencil.run) add(cell_begin[cell + run], cell_begin[cell + run + 3]);
  }

  Neighborhood(const Grid& grid, const std::vector<std::int32_t>& cell_begin, const int* cell) {
    const int fast = grid.order[0];
    for (int a = -1; a <= 1; ++a) {
      for (int b = -1; b <= 1; ++b) {
        int other[3] = {cell[0], cell[1], cell[2]};
        if (!step(grid, other, grid.order[2], a) || !step(grid, other, grid.order[1], b)) continue;
        if (grid.periodic[fast]) {
          for (int c = -1; c <= 1; ++c) {
            int one[3] = {other[0], other[1], other[2]};
            step(grid, one, fast, c);
            add(cell_begin[grid.index(one)], cell_begin[grid.index(one) + 1]);
          }
        } else {
          int one[3] = {other[0], other[1], other[2]};
          one[fast] = std::max(0, cell[fast] - 1);
          const int from = grid.index(one);
          one[fast] = std::min(grid.count[fast] - 1, cell[fast] + 1);
          add(cell_begin[from], cell_begin[grid.index(one) + 1]);
        }
      }
    }
  }

  const SlotRange* ranges() const { return ranges_; }
  int count() const { return size_; }
  std::int32_t spheres() const {
    std::int32_t sum = 0;
    for (int n = 0; n < size_; ++n) sum += ranges_[n].end - ranges_[n].begin;
    return sum;
  }

 private:
  static bool step(const Grid& grid, int* cell, int axis, int by) {
    cell[axis] += by;
    if (grid.periodic[axis]) {
      cell[axis] = (cell[axis] + grid.count[axis]) % grid.count[axis];
      return true;
    }
    return cell[axis] >= 0 && cell[axis] < grid.count[axis];
  }
  void add(std::int32_t begin, std::int32_t end) {
    if (begin < end) ranges_[size_++] = {begin, end};
  }
  SlotRange ranges_[27];
  int size_ = 0;
};

/// Everything about the spheres in cell order that the search reads.
struct Sorted {
  std::vector<double> x[3], radius;
  std::vector<std::int32_t> fiber, sphere, cell_begin, cell_of;
};

/// Lanes of the widest vector.
constexpr std::size_t widest = 8;

Sorted sorted_by_cell(const Grid& grid, const SphereSet& spheres) {
  const auto n = static_cast<std::int32_t>(spheres.position.size());
  Sorted sorted;
  std::vector<std::int32_t>& cell_of = sorted.cell_of;
  cell_of.resize(n);
  sorted.cell_begin.assign(grid.cells() + 1, 0);
  for (std::int32_t s = 0; s < n; ++s) {
    const auto& x = spheres.position[s];
    const int cell[3] = {grid.cell_along(0, x[0]), grid.cell_along(1, x[1]), grid.cell_along(2, x[2])};
    cell_of[s] = grid.index(cell);
    ++sorted.cell_begin[cell_of[s] + 1];
  }
  for (int c = 0; c < grid.cells(); ++c) sorted.cell_begin[c + 1] += sorted.cell_begin[c];
  for (auto& numbers : sorted.x) numbers.resize(n + widest);
  sorted.radius.resize(n + widest);
  sorted.fiber.resize(n);
  sorted.sphere.resize(n);
  std::vector<std::int32_t> next(sorted.cell_begin.begin(), sorted.cell_begin.end() - 1);
  for (std::int32_t s = 0; s < n; ++s) {
    const std::int32_t at = next[cell_of[s]]++;
    for (int c = 0; c < 3; ++c) sorted.x[c][at] = spheres.position[s][c];
    sorted.radius[at] = spheres.radius[s];
    sorted.fiber[at] = spheres.fiber[s];
    sorted.sphere[at] = s;
  }
  return sorted;
}

SortedSpheres view_of(const Sorted& sorted, const SphereSet& spheres, double skin) {
  SortedSpheres view{{sorted.x[0].data(), sorted.x[1].data(), sorted.x[2].data()}, sorted.radius.data(),
                     sorted.sphere.data(), sorted.fiber.data(), {}, {}, skin};
  for (int c = 0; c < 3; ++c) {
    view.period[c] = spheres.period[c];
    view.inverse_period[c] = spheres.period[c] > 0 ? 1 / spheres.period[c] : 0;
  }
  return view;
}

/// Pairs of the spheres begin ... end - 1 with those of higher number.
std::vector<ClosePair> search_run(const Grid& grid, const Sorted& sorted, const SphereSet& spheres, double skin,
                                  std::int32_t begin, std::int32_t end, const ContactKernel& kernel) {
  const SortedSpheres view = view_of(sorted, spheres, skin);
  std::vector<ClosePair> pairs;
  std::vector<std::int32_t> found;
  int last_cell = -1;
  const Stencil stencil(grid);
  std::optional<Neighborhood> near;
  for (std::int32_t i = begin; i < end; ++i) {
    const Vec<double, 3>& x = spheres.position[i];
    if (const int own_cell = sorted.cell_of[i]; own_cell != last_cell) {
      const int cell[3] = {grid.cell_along(0, x[0]), grid.cell_along(1, x[1]), grid.cell_along(2, x[2])};
      grid.inside(cell) ? near.emplace(stencil, sorted.cell_begin, own_cell) : near.emplace(grid, sorted.cell_begin, cell);
      last_cell = own_cell;
      if (found.size() < static_cast<std::size_t>(near->spheres())) found.resize(near->spheres());
    }
    const Asking own{{x[0], x[1], x[2]}, spheres.radius[i], i, spheres.fiber[i]};
    const int count = kernel.near(view, near->ranges(), near->count(), own, found.data());
    if (count > 1) std::sort(found.begin(), found.begin() + count);
    for (int n = 0; n < count; ++n) pairs.push_back({i, found[n]});
  }
  return pairs;
}

}  // namespace

std::vector<std::vector<ClosePair>> close_pairs(const SphereSet& spheres, double skin,
                                                const std::vector<std::int32_t>& run_begin, int threads,
                                                const ContactKernel& kernel) {
  const double largest = *std::ranges::max_element(spheres.radius);
  const Grid grid = grid_for(spheres, 2 * largest + skin);
  const Sorted sorted = sorted_by_cell(grid, spheres);
  const int runs = static_cast<int>(run_begin.size()) - 1;
  std::vector<std::vector<ClosePair>> pairs(runs);
#pragma omp parallel for num_threads(threads) schedule(dynamic) if (threads > 1)
  for (int k = 0; k < runs; ++k) pairs[k] = search_run(grid, sorted, spheres, skin, run_begin[k], run_begin[k + 1], kernel);
  return pairs;
}

}  // namespace fiberchain::dem
