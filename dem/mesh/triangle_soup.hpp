#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem/math/vec.hpp"

namespace fiberchain::dem {

/// Largest number of triangles of a mesh: some 0.5 kB each while it is made.
inline constexpr std::int64_t most_triangles = 2'000'000;

/// Triangles as a file lists them, in its own unit: corners that are shared may be listed once or for each.
struct TriangleSoup {
  std::vector<Vec<double, 3>> vertices;
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< numbers of vertices, counterclockwise from outside
};

}  // namespace fiberchain::dem
