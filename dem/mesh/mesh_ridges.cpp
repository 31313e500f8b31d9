#include "dem/mesh/mesh_ridges.hpp"

#include <utility>

namespace fiberchain::dem {
namespace {

Vec<double, 3> unit(const Vec<double, 3>& v) { return (1 / norm(v)) * v; }

/// From counts of each to where each begins, and the end.
std::vector<std::size_t> begins(std::vector<std::size_t> counts) {
  std::size_t sum = 0;
  for (std::size_t& n : counts) sum += std::exchange(n, sum);
  counts.push_back(sum);
  return counts;
}

void add_faces(const TriangleMesh& mesh, MeshRidges& all) {
  std::vector<std::size_t> counts;
  for (const MeshEdge& edge : mesh.edges) counts.push_back(edge.faces);
  all.faces_begin = begins(counts);
  all.into_faces.resize(all.faces_begin.back());
  std::vector<std::size_t> next = all.faces_begin;
  for (std::int32_t t = 0; t < mesh.faces(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto corner = [&](int n) { return mesh.vertices[mesh.triangles[t][(k + n) % 3]]; };
      const Vec<double, 3> along = unit(corner(1) - corner(0)), across = corner(2) - corner(0);
      all.into_faces[next[mesh.edges_of[t][k]]++] = unit(across - dot(across, along) * along);
    }
  }
}

bool is_bent(std::span<const Vec<double, 3>> into_faces) {
  return into_faces.size() != 2 || norm(into_faces[0] + into_faces[1]) > flat_angle;
}

void add_ways(const TriangleMesh& mesh, MeshRidges& all) {
  std::vector<std::size_t> counts(mesh.vertices.size());
  for (const MeshEdge& edge : mesh.edges) ++counts[edge.low], ++counts[edge.high];
  all.ways_begin = begins(counts);
  all.ways.resize(all.ways_begin.back());
  std::vector<std::size_t> next = all.ways_begin;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const MeshEdge& edge = mesh.edges[e];
    const Vec<double, 3> along = unit(mesh.vertices[edge.high] - mesh.vertices[edge.low]);
    const bool ridge = all.is_ridge[e] != 0;
    all.ways[next[edge.low]++] = {along, ridge};
    all.ways[next[edge.high]++] = {-along, ridge};
  }
}

}  // namespace

MeshRidges ridges_of(const TriangleMesh& mesh) {
  MeshRidges all;
  add_faces(mesh, all);
  for (std::int32_t e = 0; e < std::ssize(mesh.edges); ++e)
    all.is_ridge.push_back(is_bent(all.into_faces_at(e)) ? 1 : 0);
  add_ways(mesh, all);
  return all;
}

}  // namespace fiberchain::dem
