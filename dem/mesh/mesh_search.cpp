#include "dem/mesh/mesh_search.hpp"

#include <numeric>
#include <span>
#include <utility>

namespace fiberchain::dem {

struct MeshSearch::Builder {
  const std::vector<Vec<double, 3>>& vertices;
  const std::vector<std::array<std::int32_t, 3>>& triangles;
  MeshSearch& tree;

  double middle(std::int32_t t, int axis) const {
    double sum = 0;
    for (const std::int32_t v : triangles[t]) sum += vertices[v][axis];
    return sum;
  }

  MeshBox box_of(std::span<const std::int32_t> some) const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    MeshBox box{{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}};
    for (const std::int32_t t : some) {
      for (const std::int32_t v : triangles[t]) box.add(vertices[v]);
    }
    return box;
  }

  /// The nodes of some triangles, the first of which is at `first`.
  void build(std::span<std::int32_t> some, std::int32_t first) {
    const MeshBox box = box_of(some);
    const auto number = tree.nodes_.size();
    const auto count = static_cast<std::int32_t>(some.size());
    tree.nodes_.push_back({box, first, count});
    if (count <= leaf_size) return;
    int axis = 0;
    for (int c = 1; c < 3; ++c) {
      if (box.high[c] - box.low[c] > box.high[axis] - box.low[axis]) axis = c;
    }
    const std::size_t half = some.size() / 2;
    std::ranges::nth_element(some, some.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [&](std::int32_t t) { return std::pair(middle(t, axis), t); });
    build(some.first(half), first);
    const auto right = static_cast<std::int32_t>(tree.nodes_.size());
    build(some.subspan(half), first + static_cast<std::int32_t>(half));
    tree.nodes_[number].first = right, tree.nodes_[number].count = 0;
  }
};

MeshSearch::MeshSearch(const std::vector<Vec<double, 3>>& vertices,
                       const std::vector<std::array<std::int32_t, 3>>& triangles)
    : order_(triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  Builder{vertices, triangles, *this}.build(order_, 0);
}

}  // namespace fiberchain::dem
