#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dem/mesh/triangle_mesh.hpp"

namespace fiberchain::dem {

/// Where a mesh stands out or falls in: edges at which it is bent, ends or branches, "ridges", and what lies
/// around each edge and corner. A straight body touches these, and faces with its ends alone.
struct MeshRidges {
  /// A way along an edge, from one of its corners.
  struct Way {
    Vec<double, 3> along;  ///< unit vector
    bool is_ridge;
  };

  std::vector<std::uint8_t> is_ridge;       ///< of each edge
  std::vector<std::size_t> faces_begin{0};  ///< of each edge in into_faces, and the end
  std::vector<Vec<double, 3>> into_faces;   ///< unit vectors from an edge into its faces, across it
  std::vector<std::size_t> ways_begin{0};   ///< of each corner in ways, and the end
  std::vector<Way> ways;

  std::span<const Vec<double, 3>> into_faces_at(std::int32_t edge) const {
    return std::span(into_faces).subspan(faces_begin[edge], faces_begin[edge + 1] - faces_begin[edge]);
  }
  std::span<const Way> ways_from(std::int32_t corner) const {
    return std::span(ways).subspan(ways_begin[corner], ways_begin[corner + 1] - ways_begin[corner]);
  }
};

/// Faces that meet at less than this angle [rad] are flat.
inline constexpr double flat_angle = 1e-3;

MeshRidges ridges_of(const TriangleMesh& mesh);

}  // namespace fiberchain::dem
