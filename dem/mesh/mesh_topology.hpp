#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dem/mesh/triangle_mesh.hpp"

namespace fiberchain::dem {

/// What a mesh is like as a surface.
struct MeshTopology {
  std::int64_t rims = 0;                              ///< edges of one triangle: the surface is open there
  std::int64_t branches = 0;                          ///< edges of three triangles or more
  std::optional<std::array<std::int32_t, 2>> turned;  ///< triangles at an edge that look to opposite sides
  double volume = 0;  ///< inside of a closed mesh [m^3]; negative where its normals point inside
};

MeshTopology topology_of(const TriangleMesh& mesh);

/// Two triangles that cross each other without a corner in common; nothing where there are none.
std::optional<std::array<std::int32_t, 2>> crossing_triangles(const TriangleMesh& mesh);

/// Meshes of more triangles are not searched for crossings where notes are wanted.
inline constexpr std::int32_t most_searched_for_crossings = 500'000;

/// What a user should know of a mesh, a sentence each: triangles left out, open, branched, inside-out,
/// crossing itself. `one_sided`: fibers touch it from outside alone.
std::vector<std::string> notes_on(const TriangleMesh& mesh, bool one_sided);

}  // namespace fiberchain::dem
