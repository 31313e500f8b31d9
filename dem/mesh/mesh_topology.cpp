#include "dem/mesh/mesh_topology.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fiberchain::dem {
namespace {

using Corners = std::array<Vec<double, 3>, 3>;

Corners corners_of(const TriangleMesh& mesh, std::int32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

bool share_corner(const TriangleMesh& mesh, std::int32_t one, std::int32_t other) {
  return std::ranges::any_of(mesh.triangles[one], [&](std::int32_t v) {
    return std::ranges::find(mesh.triangles[other], v) != mesh.triangles[other].end();
  });
}

/// Whether a side of one goes through the other.
bool goes_through(const TriangleMesh& mesh, std::int32_t one, std::int32_t other) {
  const Corners x = corners_of(mesh, one);
  const TrianglePlane& plane = mesh.planes[other];
  return pierces(plane, x[0], x[1]) || pierces(plane, x[1], x[2]) || pierces(plane, x[2], x[0]);
}

MeshBox box_of(const Corners& corners) {
  MeshBox box{corners[0], corners[0]};
  for (const Vec<double, 3>& x : corners) box.add(x);
  return box;
}

/// Whether a triangle runs along an edge from its low to its high corner.
bool runs_up(const TriangleMesh& mesh, std::int32_t t, int side) {
  return mesh.triangles[t][side] < mesh.triangles[t][(side + 1) % 3];
}

double volume_of(const TriangleMesh& mesh) {
  double sum = 0;
  const Vec<double, 3> origin = mesh.vertices.front();
  for (std::int32_t t = 0; t < mesh.faces(); ++t) {
    const Corners x = corners_of(mesh, t);
    sum += dot(x[0] - origin, cross(x[1] - origin, x[2] - origin)) / 6;
  }
  return sum;
}

}  // namespace

MeshTopology topology_of(const TriangleMesh& mesh) {
  MeshTopology all;
  std::vector<std::int32_t> first(mesh.edges.size(), -1);
  std::vector<bool> up(mesh.edges.size());
  for (const MeshEdge& edge : mesh.edges) {
    all.rims += edge.faces == 1 ? 1 : 0;
    all.branches += edge.faces > 2 ? 1 : 0;
  }
  for (std::int32_t t = 0; t < mesh.faces(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t edge = mesh.edges_of[t][k];
      if (mesh.edges[edge].faces != 2) continue;
      if (first[edge] < 0) {
        first[edge] = t, up[edge] = runs_up(mesh, t, k);
      } else if (up[edge] == runs_up(mesh, t, k) && !all.turned) {
        all.turned = {first[edge], t};
      }
    }
  }
  if (mesh.is_closed) all.volume = volume_of(mesh);
  return all;
}

std::optional<std::array<std::int32_t, 2>> crossing_triangles(const TriangleMesh& mesh) {
  std::optional<std::array<std::int32_t, 2>> found;
  for (std::int32_t t = 0; t < mesh.faces() && !found; ++t) {
    mesh.search.overlapping(box_of(corners_of(mesh, t)), [&](std::int32_t other) {
      if (found || other <= t || share_corner(mesh, t, other)) return;
      if (goes_through(mesh, t, other) || goes_through(mesh, other, t)) found = {t, other};
    });
  }
  return found;
}

std::vector<std::string> notes_on(const TriangleMesh& mesh, bool one_sided) {
  std::vector<std::string> notes;
  const MeshTopology all = topology_of(mesh);
  if (mesh.left_out > 0)
    notes.push_back(fmt::format("{} triangles without area are left out", mesh.left_out));
  if (all.rims > 0)
    notes.push_back(fmt::format("is open: {} of its {} edges belong to one triangle alone{}", all.rims,
                                mesh.edges.size(), one_sided ? "; fibers pass through it from behind" : ""));
  if (all.branches > 0)
    notes.push_back(fmt::format("{} of its edges belong to more than two triangles", all.branches));
  if (one_sided && all.volume < 0)
    notes.push_back("is closed and inside-out (its normals point inside): fibers belong inside of it");
  if (mesh.faces() > most_searched_for_crossings) {
    notes.push_back(fmt::format("was not searched for places where it crosses itself: more than {} triangles",
                                most_searched_for_crossings));
  } else if (const auto pair = crossing_triangles(mesh)) {
    notes.push_back(fmt::format("crosses itself, triangles {} and {} first: fibers touch both",
                                (*pair)[0] + 1, (*pair)[1] + 1));
  }
  return notes;
}

}  // namespace fiberchain::dem
