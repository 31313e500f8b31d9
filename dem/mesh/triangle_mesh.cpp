#include "dem/mesh/triangle_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dem/model/errors.hpp"
#include "dem/model/invalid_key.hpp"

namespace fiberchain::dem {
namespace {

constexpr double farthest_mesh = 1e6;  // [m]
/// Height over length of a triangle that has an area.
constexpr double thinnest_triangle = 1e-10;

/// A vertex for every place; where each listed one went.
std::vector<std::int32_t> weld(std::vector<Vec<double, 3>>& vertices) {
  const auto place = [&](std::int32_t v) {
    const Vec<double, 3>& x = vertices[v];
    return std::array{x[0], x[1], x[2]};
  };
  std::vector<std::int32_t> order(vertices.size()), number(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, place);
  std::vector<Vec<double, 3>> welded;
  // numbers by the first time a place is listed: files that list shared corners once keep theirs
  std::vector<std::int32_t> first(vertices.size());
  for (std::size_t n = 0; n < order.size(); ++n)
    first[order[n]] = n > 0 && place(order[n]) == place(order[n - 1]) ? first[order[n - 1]] : order[n];
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (first[v] == static_cast<std::int32_t>(v)) {
      number[v] = static_cast<std::int32_t>(welded.size());
      welded.push_back(vertices[v]);
    } else {
      number[v] = number[first[v]];
    }
  }
  vertices = std::move(welded);
  return number;
}

/// The plane of a triangle; its normal is zero where it has no area.
TrianglePlane plane_of(const Vec<double, 3>& a, const Vec<double, 3>& b, const Vec<double, 3>& c) {
  const Vec<double, 3> u = b - a, v = c - a, w = cross(u, v);
  const double area = norm(w), longest = std::max({dot(u, u), dot(v, v), dot(v - u, v - u)});
  if (!(area > thinnest_triangle * longest)) return {a, {}, {}, {}};
  const Vec<double, 3> normal = (1 / area) * w;
  return {a, normal, (1 / area) * cross(v, normal), (1 / area) * cross(normal, u)};
}

/// Side of a triangle as it stands in it.
struct EdgeUse {
  std::int32_t low, high, triangle;
  std::int8_t side;
  bool rising;
};

std::vector<EdgeUse> edge_uses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::int32_t t = 0; t < mesh.faces(); ++t) {
    for (std::int8_t k = 0; k < 3; ++k) {
      const std::int32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  }
  std::ranges::sort(uses, {}, [](const EdgeUse& u) { return std::array{u.low, u.high, u.triangle}; });
  return uses;
}

/// Numbers the edges. Whether each has two faces that run along it in opposite directions.
bool join_edges(TriangleMesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  mesh.edges_of.resize(mesh.triangles.size());
  bool closed = true;
  for (std::size_t n = 0; n < uses.size();) {
    MeshEdge edge{uses[n].low, uses[n].high};
    int rising = 0;
    for (; n < uses.size() && uses[n].low == edge.low && uses[n].high == edge.high; ++n) {
      mesh.edges_of[uses[n].triangle][uses[n].side] = static_cast<std::int32_t>(mesh.edges.size());
      edge.outward = edge.outward + mesh.planes[uses[n].triangle].normal;
      ++edge.faces, rising += uses[n].rising ? 1 : 0;
    }
    closed = closed && edge.faces == 2 && rising == 1;
    mesh.edges.push_back(edge);
  }
  return closed;
}

void join_corners(TriangleMesh& mesh) {
  mesh.corners.resize(mesh.vertices.size());
  for (std::int32_t t = 0; t < mesh.faces(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](int n) { return mesh.vertices[mesh.triangles[t][(k + n) % 3]]; };
      const Vec<double, 3> u = at(1) - at(0), v = at(2) - at(0);
      MeshCorner& corner = mesh.corners[mesh.triangles[t][k]];
      ++corner.faces;
      corner.outward = corner.outward + std::atan2(norm(cross(u, v)), dot(u, v)) * mesh.planes[t].normal;
    }
  }
  for (const MeshEdge& edge : mesh.edges) {
    if (edge.faces == 1) mesh.corners[edge.low].on_rim = mesh.corners[edge.high].on_rim = true;
  }
}

/// Vertices [m] without signs of zeros.
std::vector<Vec<double, 3>> scaled(const std::vector<Vec<double, 3>>& listed, double scale,
                                   const std::string& name) {
  std::vector<Vec<double, 3>> vertices;
  vertices.reserve(listed.size());
  for (Vec<double, 3> x : listed) {
    for (double& c : x.c) {
      c = scale * c + 0.0;
      if (!(std::abs(c) <= farthest_mesh))
        throw InvalidKey("scale", fmt::format("{}: a coordinate of {:g} m is not allowed: at most {:g} m",
                                              name, c, farthest_mesh));
    }
    vertices.push_back(x);
  }
  return vertices;
}

}  // namespace

bool pierces(const TrianglePlane& triangle, const Vec<double, 3>& from, const Vec<double, 3>& to) {
  const Vec<double, 3> a = from - triangle.corner, b = to - triangle.corner;
  const double before = dot(a, triangle.normal), behind = dot(b, triangle.normal);
  if (!(before * behind < 0)) return false;
  const Vec<double, 3> at = a + (before / (before - behind)) * (b - a);
  const double second = dot(at, triangle.to_second), third = dot(at, triangle.to_third);
  return second > 0 && third > 0 && second + third < 1;
}

TriangleMesh make_mesh(const TriangleSoup& soup, double scale, const std::string& name) {
  TriangleMesh mesh;
  mesh.name = name;
  mesh.vertices = scaled(soup.vertices, scale, name);
  const std::vector<std::int32_t> number = weld(mesh.vertices);
  for (const auto& listed : soup.triangles) {
    const std::array<std::int32_t, 3> t{number[listed[0]], number[listed[1]], number[listed[2]]};
    const TrianglePlane plane = plane_of(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    if (norm(plane.normal) == 0) {
      ++mesh.left_out;
      continue;
    }
    mesh.triangles.push_back(t);
    mesh.planes.push_back(plane);
  }
  if (mesh.triangles.empty())
    throw InvalidInput(fmt::format("{}: none of its {} triangles has an area", name, soup.triangles.size()));
  mesh.is_closed = join_edges(mesh);
  join_corners(mesh);
  mesh.search = MeshSearch(mesh.vertices, mesh.triangles);
  return mesh;
}

}  // namespace fiberchain::dem
