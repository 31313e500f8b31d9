#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// Box along the axes.
struct MeshBox {
  Vec<double, 3> low, high;  ///< [m]

  /// Squared distance of a place [m^2]; 0 inside.
  double squared_distance(const Vec<double, 3>& x) const {
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
      const double out = std::max({low[c] - x[c], x[c] - high[c], 0.0});
      sum += out * out;
    }
    return sum;
  }
  void add(const Vec<double, 3>& x) {
    for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], x[c]), high[c] = std::max(high[c], x[c]);
  }
  bool overlaps(const MeshBox& other) const {
    for (int c = 0; c < 3; ++c) {
      if (low[c] > other.high[c] || high[c] < other.low[c]) return false;
    }
    return true;
  }
};

/// Binary tree of boxes around triangles, halved by their middles along the longest side: what is far from
/// all of them is told at the root, the cost of a search is that of what is near.
class MeshSearch {
 public:
  MeshSearch() = default;
  MeshSearch(const std::vector<Vec<double, 3>>& vertices,
             const std::vector<std::array<std::int32_t, 3>>& triangles);

  /// Around all.
  const MeshBox& box() const { return nodes_.front().box; }

  /// visit(triangle) for all in leaves whose boxes are nearer to a place than `reach` [m], in an order that
  /// the mesh alone sets.
  template <class Visit>
  void near(const Vec<double, 3>& place, double reach, const Visit& visit) const {
    walk([&](const MeshBox& box) { return box.squared_distance(place) <= reach * reach; }, visit);
  }

  /// The same of leaves whose boxes overlap one.
  template <class Visit>
  void overlapping(const MeshBox& other, const Visit& visit) const {
    walk([&](const MeshBox& box) { return box.overlaps(other); }, visit);
  }

  /// The nearest one: squared_distance(triangle) says how far it is [m^2]; of equal ones the lowest.
  template <class SquaredDistance>
  std::int32_t nearest(const Vec<double, 3>& place, const SquaredDistance& squared_distance) const {
    double least = std::numeric_limits<double>::infinity();
    std::int32_t best = 0;
    std::array<std::int32_t, most_levels> stack;
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
      const Node& node = nodes_[stack[--size]];
      if (node.box.squared_distance(place) > least) continue;
      if (node.count == 0) {
        const std::int32_t left = static_cast<std::int32_t>(&node - nodes_.data()) + 1;
        const bool left_first =
            nodes_[left].box.squared_distance(place) < nodes_[node.first].box.squared_distance(place);
        stack[size++] = left_first ? node.first : left;
        stack[size++] = left_first ? left : node.first;
        continue;
      }
      for (std::int32_t n = node.first; n < node.first + node.count; ++n) {
        const double squared = squared_distance(order_[n]);
        if (squared < least || (squared == least && order_[n] < best)) least = squared, best = order_[n];
      }
    }
    return best;
  }

 private:
  static constexpr int most_levels = 64;  // halves of 2^31 triangles, one waiting at each
  static constexpr std::int32_t leaf_size = 4;

  struct Node {
    MeshBox box;
    std::int32_t first;  ///< of a leaf's triangles in order_; else the right child, the left one is next
    std::int32_t count;  ///< 0: no leaf
  };

  template <class Enter, class Visit>
  void walk(const Enter& enter, const Visit& visit) const {
    std::array<std::int32_t, most_levels> stack;
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
      const std::int32_t number = stack[--size];
      const Node& node = nodes_[number];
      if (!enter(node.box)) continue;
      if (node.count == 0) {
        stack[size++] = node.first;
        stack[size++] = number + 1;
      } else {
        for (std::int32_t n = node.first; n < node.first + node.count; ++n) visit(order_[n]);
      }
    }
  }

  struct Builder;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> order_;  ///< triangles
};

}  // namespace fiberchain::dem
