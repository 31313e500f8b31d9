#include "compare/render/scenery.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <unordered_map>

namespace fiberchain::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_endless(const dem::WallSurface& wall) { return wall.shape == "plane"; }

void take_in(Bounds& bounds, const Point& point, double radius) {
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(point[c])) continue;
    bounds.low[c] = std::min(bounds.low[c], point[c] - radius);
    bounds.high[c] = std::max(bounds.high[c], point[c] + radius);
  }
}

Bounds bounds_of(const dem::TrajectoryFrame& frame, const std::vector<dem::WallSurface>& walls) {
  Bounds bounds{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (std::size_t i = 0; i < frame.position.size(); ++i) take_in(bounds, frame.position[i], frame.radius[i]);
  for (std::size_t w = 0; w < std::min(walls.size(), frame.walls.size()); ++w) {
    if (is_endless(walls[w]) || !frame.walls[w].is_there) continue;
    for (const Point& point : walls[w].points) take_in(bounds, placed_at(frame.walls[w], point), 0);
  }
  for (int c = 0; c < 3; ++c) {
    constexpr double near = 0.15;  // of the scene's box
    const double size = frame.high[c] - frame.low[c];
    const bool whole = frame.periodic[c] || !(bounds.low[c] <= bounds.high[c]);
    const double below = bounds.low[c] - frame.low[c], above = frame.high[c] - bounds.high[c];
    // fibers stick out of periodic sides
    if (below > 0 && (whole || below < near * size)) bounds.low[c] = frame.low[c];
    if (above > 0 && (whole || above < near * size)) bounds.high[c] = frame.high[c];
  }
  return bounds;
}

using Polygon = std::vector<Point>;

/// What of it lies where sign * x[c] <= sign * end.
Polygon cut(const Polygon& polygon, int c, double sign, double end) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = sign * (a[c] - end), to = sign * (b[c] - end);
    if (from <= 0) kept.push_back(a);
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.push_back(a + (from / (from - to)) * (b - a));
  }
  return kept;
}

/// Of three corners a polygon; of two, which are there and back, a segment.
Polygon cut(Polygon polygon, const Bounds& box, double round_off) {
  for (int c = 0; c < 3; ++c) {
    polygon = cut(polygon, c, 1, box.high[c] + round_off);
    polygon = cut(polygon, c, -1, box.low[c] - round_off);
  }
  return polygon;
}

bool is_inside(const Point& point, const Bounds& box) {
  for (int c = 0; c < 3; ++c) {
    if (point[c] < box.low[c] || point[c] > box.high[c]) return false;
  }
  return true;
}

Point normal_of(const std::array<Point, 3>& triangle) {
  const Point n = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double size = norm(n);
  return size > 0 ? (1 / size) * n : n;
}

/// The first triangle at an edge, and whether the edge shows.
struct EdgeUse {
  std::size_t triangle;
  bool shows;
};

/// Edges of one triangle, or between two at an angle.
void add_edges(const dem::WallSurface& wall, const std::vector<std::array<Point, 3>>& triangles,
               const std::vector<Point>& points, std::vector<std::array<Point, 2>>& edges) {
  constexpr double smooth = 0.77;  // cosine of 40 degrees
  std::unordered_map<std::uint64_t, EdgeUse> uses;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::uint64_t>(wall.triangles[t][k]),
                 b = static_cast<std::uint64_t>(wall.triangles[t][(k + 1) % 3]);
      const auto [found, first] = uses.try_emplace(std::min(a, b) << 32 | std::max(a, b), EdgeUse{t, true});
      if (first) continue;
      found->second.shows =
          dot(normal_of(triangles[t]), normal_of(triangles[found->second.triangle])) < smooth;
    }
  }
  std::vector<std::uint64_t> shown;
  for (const auto& [key, use] : uses) {
    if (use.shows) shown.push_back(key);
  }
  std::ranges::sort(shown);  // the same order with every library
  for (const std::uint64_t key : shown) edges.push_back({points[key >> 32], points[key & 0xffffffff]});
}

/// The edges of a box.
void add_box(const Point& low, const Point& high, std::vector<std::array<Point, 2>>& edges) {
  for (unsigned i = 0; i < 8; ++i) {
    const auto corner = [&](unsigned n) {
      return Point{n & 1 ? high[0] : low[0], n & 2 ? high[1] : low[1], n & 4 ? high[2] : low[2]};
    };
    for (const unsigned side : {1u, 2u, 4u}) {
      if ((i & side) == 0) edges.push_back({corner(i), corner(i | side)});
    }
  }
}

}  // namespace

Bounds joined(const Bounds& a, const Bounds& b) {
  Bounds all = a;
  for (int c = 0; c < 3; ++c)
    all.low[c] = std::min(a.low[c], b.low[c]), all.high[c] = std::max(a.high[c], b.high[c]);
  return all;
}

Bounds shown_bounds(std::span<const dem::TrajectoryFrame> frames,
                    const std::vector<dem::WallSurface>& walls) {
  Bounds all = bounds_of(frames.front(), walls);
  for (const dem::TrajectoryFrame& frame : frames.subspan(1)) all = joined(all, bounds_of(frame, walls));
  return all;
}

Scenery scenery_of(const dem::TrajectoryFrame& frame, const std::vector<dem::WallSurface>& walls,
                   const Bounds& shown) {
  Scenery scenery;
  const double round_off = 1e-6 * norm(shown.high - shown.low),
               bottom = shown.low[2] + 0.02 * (shown.high[2] - shown.low[2]);
  for (std::size_t w = 0; w < std::min(walls.size(), frame.walls.size()); ++w) {
    if (!frame.walls[w].is_there) continue;
    std::vector<Point> points;
    for (const Point& point : walls[w].points) points.push_back(placed_at(frame.walls[w], point));
    std::vector<std::array<Point, 3>> triangles;
    for (const auto& t : walls[w].triangles)
      triangles.push_back({points[static_cast<std::size_t>(t[0])], points[static_cast<std::size_t>(t[1])],
                           points[static_cast<std::size_t>(t[2])]});
    for (const auto& triangle : triangles) {
      const bool whole =
          std::ranges::all_of(triangle, [&](const Point& corner) { return is_inside(corner, shown); });
      const Polygon polygon = whole ? Polygon(triangle.begin(), triangle.end())
                                    : cut({triangle[0], triangle[1], triangle[2]}, shown, round_off);
      const bool is_floor =
          is_endless(walls[w]) && std::abs(normal_of(triangle)[2]) > 0.99 &&
          std::ranges::all_of(polygon, [&](const Point& corner) { return corner[2] <= bottom; });
      auto& to = is_floor ? scenery.floor : scenery.facets;
      for (std::size_t i = 2; i < polygon.size(); ++i) to.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
    std::vector<std::array<Point, 2>> edges;
    add_edges(walls[w], triangles, points, edges);
    for (const auto& edge : edges) {
      const Polygon segment = cut({edge[0], edge[1]}, shown, round_off);
      if (segment.size() >= 2) scenery.edges.push_back({segment[0], segment[1]});
    }
  }
  if (std::ranges::any_of(frame.periodic, std::identity()))
    add_box({std::max(frame.low[0], shown.low[0]), std::max(frame.low[1], shown.low[1]),
             std::max(frame.low[2], shown.low[2])},
            {std::min(frame.high[0], shown.high[0]), std::min(frame.high[1], shown.high[1]),
             std::min(frame.high[2], shown.high[2])},
            scenery.edges);
  return scenery;
}

}  // namespace fiberchain::compare
