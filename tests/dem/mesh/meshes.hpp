#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "dem/mesh/mesh_shape.hpp"

/// Surfaces of triangles that tests make themselves.
namespace meshes {

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

inline void add_triangle(dem::TriangleSoup& soup, const V& a, const V& b, const V& c) {
  const auto first = static_cast<std::int32_t>(soup.vertices.size());
  soup.vertices.insert(soup.vertices.end(), {a, b, c});
  soup.triangles.push_back({first, first + 1, first + 2});
}

/// Four corners counterclockwise from outside, cut along one diagonal or the other.
inline void add_quad(dem::TriangleSoup& soup, const V& a, const V& b, const V& c, const V& d,
                     bool other = false) {
  add_triangle(soup, a, b, other ? d : c);
  other ? add_triangle(soup, b, c, d) : add_triangle(soup, a, c, d);
}

/// The surface at(u, v) over the unit square, n by m cells; seen from the side of du x dv.
inline dem::TriangleSoup patch(int n, int m, const std::function<V(double, double)>& at) {
  dem::TriangleSoup soup;
  const auto corner = [&](int i, int j) {
    return at(static_cast<double>(i) / n, static_cast<double>(j) / m);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j)
      add_quad(soup, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1),
               (i + j) % 2 == 1);
  }
  return soup;
}

/// A piece of the plane z = 0 around the origin, cut into triangles of odd shapes.
inline dem::TriangleSoup flat(double half, int cells, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-0.3, 0.3);
  std::vector<V> at((cells + 1) * (cells + 1));
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const bool rim = i == 0 || j == 0 || i == cells || j == cells;
      const double u = i + (rim ? 0 : number(random)), v = j + (rim ? 0 : number(random));
      at[i * (cells + 1) + j] = {half * (2 * u / cells - 1), half * (2 * v / cells - 1), 0};
    }
  }
  dem::TriangleSoup soup;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const V *a = &at[i * (cells + 1) + j], *b = a + cells + 1;
      add_quad(soup, a[0], b[0], b[1], a[1], (i * 7 + j * 3) % 2 == 1);
    }
  }
  return soup;
}

/// A box around the origin with these half sides, normals to the outside; each face of cells x cells quads.
inline dem::TriangleSoup box(const V& half, int cells = 1) {
  dem::TriangleSoup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto share = [&](double u) {
        return (2 * std::round(u * cells) - cells) / cells;
      };  // odd to the bit
      const auto at = [&](double u, double v) {
        V x{};
        x[axis] = side * half[axis];
        x[(axis + 1) % 3] = share(u) * half[(axis + 1) % 3];
        x[(axis + 2) % 3] = side * share(v) * half[(axis + 2) % 3];
        return x;
      };
      const dem::TriangleSoup face = patch(cells, cells, at);
      for (const auto& t : face.triangles)
        add_triangle(soup, face.vertices[t[0]], face.vertices[t[1]], face.vertices[t[2]]);
    }
  }
  return soup;
}

/// Inside of a tube about z, corners on the circle; `around` facets.
inline dem::TriangleSoup tube(double radius, double half_length, int around, int along) {
  return patch(along, around, [=](double u, double v) {
    const double angle = 2 * std::numbers::pi * std::round(v * around) / around;
    const double last = std::round(v * around) == around ? 0 : angle;  // where it began, to the bit
    return V{radius * std::cos(last), radius * std::sin(last), half_length * (2 * u - 1)};
  });
}

inline std::shared_ptr<const dem::TriangleMesh> mesh_of(const dem::TriangleSoup& soup, double scale = 1) {
  return std::make_shared<const dem::TriangleMesh>(dem::make_mesh(soup, scale, "mesh"));
}

inline dem::MeshShape shape_of(const dem::TriangleSoup& soup, dem::MeshSides sides = dem::MeshSides::both) {
  return {.mesh = mesh_of(soup), .sides = sides};
}

/// Of a mill (tests/dem/mill.hpp): its driven lid, a plate with its normal to -y, and its shaken funnel, a
/// cone.
inline dem::MeshShape mill_lid() {
  dem::MeshShape plate = shape_of(flat(0.03, 5), dem::MeshSides::one);
  plate.turn(dem::rotation(V{std::numbers::pi / 2, 0, 0}));
  plate.point = {0, 0.011, 0};
  return plate;
}

inline dem::MeshShape mill_funnel() {
  dem::MeshShape cone = shape_of(patch(20, 2, [](double u, double v) {
    const double turned = 2 * std::numbers::pi * (u == 1 ? 0 : u), r = 7e-3 - 4e-3 * v;
    return V{r * std::cos(turned), r * std::sin(turned), -4e-3 * v};
  }));
  cone.point = {0, 0, 14e-3};
  return cone;
}

}  // namespace meshes
