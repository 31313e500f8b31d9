#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dem/math/vec.hpp"
#include "dem/mesh/mesh_search.hpp"
#include "dem/mesh/triangle_soup.hpp"

// A surface of triangles and its parts ("features"): faces, edges, corners, numbered through in this order.
namespace fiberchain::dem {

enum class FeatureKind : std::uint8_t { face, edge, corner };

/// Of a triangle: what tells fast where over it a point lies.
struct TrianglePlane {
  Vec<double, 3> corner;     ///< its first [m]
  Vec<double, 3> normal;     ///< unit vector to the outside
  Vec<double, 3> to_second;  ///< times what lies from `corner`: share of the second corner in a point, ...
  Vec<double, 3> to_third;   ///< ... of the third [1/m]
};

/// Whether the straight way between two places goes through a triangle.
bool pierces(const TrianglePlane& triangle, const Vec<double, 3>& from, const Vec<double, 3>& to);

struct MeshEdge {
  std::int32_t low, high;    ///< its corners
  std::int32_t faces = 0;    ///< that share it
  Vec<double, 3> outward{};  ///< sum of their unit normals
};

struct MeshCorner {
  std::int32_t faces = 0;    ///< that share it
  bool on_rim = false;       ///< an edge of it belongs to one face alone
  Vec<double, 3> outward{};  ///< sum of the normals of its faces, each times its angle there
};

struct TriangleMesh {
  std::vector<Vec<double, 3>> vertices;                ///< of its own frame [m]
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< counterclockwise from outside
  std::vector<TrianglePlane> planes;                   ///< of each
  std::vector<std::array<std::int32_t, 3>> edges_of;   ///< of each, from each of its corners to the next
  std::vector<MeshEdge> edges;
  std::vector<MeshCorner> corners;  ///< of each vertex
  MeshSearch search;
  std::string name;           ///< of its file
  std::int64_t left_out = 0;  ///< triangles of the file without area
  bool is_closed = false;     ///< every edge has two faces, which look to the same side

  std::int32_t faces() const { return static_cast<std::int32_t>(triangles.size()); }
  std::int32_t features() const {
    return static_cast<std::int32_t>(triangles.size() + edges.size() + corners.size());
  }
  std::int32_t edge_feature(std::int32_t edge) const { return faces() + edge; }
  std::int32_t corner_feature(std::int32_t vertex) const {
    return faces() + static_cast<std::int32_t>(edges.size()) + vertex;
  }
  FeatureKind kind_of(std::int32_t feature) const {
    if (feature < faces()) return FeatureKind::face;
    return feature < corner_feature(0) ? FeatureKind::edge : FeatureKind::corner;
  }
  const MeshEdge& edge_at(std::int32_t feature) const { return edges[feature - faces()]; }
  const MeshCorner& corner_at(std::int32_t feature) const { return corners[feature - corner_feature(0)]; }
  const Vec<double, 3>& vertex_at(std::int32_t feature) const {
    return vertices[feature - corner_feature(0)];
  }
  /// Triangles that share it.
  std::int32_t valence(std::int32_t feature) const {
    if (feature < faces()) return 1;
    return feature < corner_feature(0) ? edge_at(feature).faces : corner_at(feature).faces;
  }
  /// Whether it lies where the surface ends.
  bool is_rim(std::int32_t feature) const {
    if (feature < faces()) return false;
    return feature < corner_feature(0) ? edge_at(feature).faces == 1 : corner_at(feature).on_rim;
  }
};

/// The surface of these triangles, `scale` [m] a unit. Corners at the same place to the bit are one;
/// triangles without area are left out.
/// @throws InvalidInput "NAME: ..." where no triangle has an area; InvalidKey "scale" where it reaches
/// farther than 1e6 m
TriangleMesh make_mesh(const TriangleSoup& soup, double scale, const std::string& name);

}  // namespace fiberchain::dem
