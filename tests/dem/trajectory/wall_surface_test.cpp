// Walls as triangles: on the walls, where they are.
#include "dem/trajectory/wall_surface.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "tests/dem/mesh/meshes.hpp"

BOOST_AUTO_TEST_SUITE(wall_surface_test)

using namespace fiberchain::dem;
using V = Vec<double, 3>;

namespace {

const V kLow{-0.03, -0.02, 0.01}, kHigh{0.05, 0.04, 0.07};

V unit_of(const V& v) { return (1 / norm(v)) * v; }

/// Every corner is on the wall, and middles of triangles are within `chord` of it.
void check_on_wall(const Wall& wall, double chord, double time) {
  const WallSurface surface = wall_surfaces({wall}, kLow, kHigh)[0];
  const FrameWall now = frame_wall(wall, time);
  BOOST_TEST(surface.shape == wall.shape.type().name);
  BOOST_TEST_REQUIRE(!surface.triangles.empty(), surface.shape);
  for (const auto& triangle : surface.triangles) {
    V middle{};
    for (const std::int32_t corner : triangle) {
      const V place = placed_at(now, surface.points.at(static_cast<std::size_t>(corner)));
      BOOST_TEST(std::abs(gap_to(wall, place, time)) < 1e-12, surface.shape);
      middle = middle + (1.0 / 3) * place;
    }
    BOOST_TEST(std::abs(gap_to(wall, middle, time)) <= chord, surface.shape);
  }
}

/// Area of all triangles [m^2].
double area(const WallSurface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const auto at = [&](int k) {
      return surface.points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
    };
    sum += 0.5 * norm(cross(at(1) - at(0), at(2) - at(0)));
  }
  return sum;
}

Wall moving(Wall wall) {
  wall.velocity = {0.01, -0.02, 0.03};
  wall.motion.about = WallAxis{{0.01, 0, 0.02}, unit_of({1, 2, 3})};
  wall.motion.angular_velocity = 1.7;
  return wall;
}

}  // namespace

BOOST_AUTO_TEST_CASE(corners_are_on_the_wall_wherever_it_is) {
  const V axis = unit_of({1, -2, 4}), other = unit_of(cross(axis, V{0, 0, 1}));
  const double R = 0.0123, rough = R * (1 - std::cos(3.15 / 48)) * 2;
  const Wall walls[] = {{Plane{{0.01, 0, 0.03}, axis}},
                        {Cylinder{{0.01, 0, 0.03}, axis, R}},
                        {Cylinder{{0.01, 0, 0.03}, axis, R, -1}},
                        {Sphere{{0.01, 0, 0.03}, R}},
                        {BoxObstacle{{0.01, 0, 0.03}, {0.002, 0.004, 0.001}, axis, other}},
                        {Cone{{0.01, 0, 0.03}, axis, 0.013, 0.004, R, 0}},
                        {Cone{{0.01, 0, 0.03}, axis, 0.013, R, 0.003, 4e-4}}};
  for (const Wall& wall : walls) {
    for (const double time : {0.0, 0.83}) check_on_wall(moving(wall), rough, time);
  }
}

/// A mesh is its own triangles, as they are numbered.
BOOST_AUTO_TEST_CASE(meshes_stand_where_they_are) {
  MeshShape shape = meshes::shape_of(meshes::flat(1, 2));
  shape.point = {0.1, 0.2, 0.3};
  Wall wall{shape};
  wall.velocity = {1, 0, 0};
  wall.motion.about = WallAxis{{0.1, 0.2, 0.3}, {0, 0, 1}};
  wall.motion.angular_velocity = std::numbers::pi / 2;
  const WallSurface surface = wall_surfaces({wall}, kLow, kHigh)[0];
  const FrameWall now = frame_wall(wall, 1);
  const TriangleMesh& mesh = *shape.mesh;
  BOOST_TEST_REQUIRE(surface.triangles.size() == 8u);
  BOOST_TEST((surface.triangles == mesh.triangles));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const V x = mesh.vertices[i], expected{1.1 - x[1], 0.2 + x[0], 0.3};
    BOOST_TEST(norm(placed_at(now, surface.points[i]) - expected) < 1e-15);
  }
  check_on_wall(moving(wall), 1e-12, 0.83);
}

BOOST_AUTO_TEST_CASE(areas_are_those_of_the_shapes) {
  const double pi = 3.14159265358979, facets = 48 / pi * std::sin(pi / 48);  // chords over arcs
  const auto of = [&](const WallShape& shape) { return area(wall_surfaces({{shape}}, kLow, kHigh)[0]); };
  const double R = 0.0123, length = kHigh[1] - kLow[1];
  BOOST_TEST(std::abs(of(Cylinder{{}, {0, 1, 0}, R}) / (2 * pi * R * length * facets) - 1) < 1e-9);
  BOOST_TEST(std::abs(of(Sphere{{}, R}) / (4 * pi * R * R) - 1) < 5e-3);
  BOOST_TEST(std::abs(of(BoxObstacle{{}, {1e-3, 2e-3, 3e-3}, {1, 0, 0}, {0, 1, 0}}) / 88e-6 - 1) < 1e-9);
  const double slant = std::hypot(0.02, 0.004);
  BOOST_TEST(std::abs(of(Cone{{}, {0, 0, 1}, 0.02, 0.008, 0.004, 0}) / (pi * 0.012 * slant) - 1) < 5e-3);
  // both sides of a shell, and a torus' half at each rim
  const double shell = 2 * pi * 0.012 * slant + pi * 2e-4 * 2 * pi * 0.012;
  BOOST_TEST(std::abs(of(Cone{{}, {0, 0, 1}, 0.02, 0.008, 0.004, 2e-4}) / shell - 1) < 1e-2);
}

BOOST_AUTO_TEST_CASE(planes_are_cut_to_the_box) {
  const V size = kHigh - kLow;
  const auto of = [&](const V& point, const V& normal) {
    return area(wall_surfaces({{Plane{point, normal}}}, kLow, kHigh)[0]);
  };
  BOOST_TEST(std::abs(of(kLow, {0, 0, 1}) / (size[0] * size[1]) - 1) < 1e-6);  // on a side of it
  BOOST_TEST(std::abs(of({0, 0.01, 0}, {0, -1, 0}) / (size[0] * size[2]) - 1) < 1e-6);
  BOOST_TEST(std::abs(of({0, 0, 0.09}, {0, 0, -1}) / (size[0] * size[1]) - 1) < 1e-9);  // beyond it
  // across a corner, sqrt(3)/2 d^2 for an equilateral triangle whose legs on the edges are d
  const double d = 0.01, third = 1 / std::sqrt(3.0);
  const V at = kLow + V{d / 3, d / 3, d / 3};
  BOOST_TEST(std::abs(of(at, {third, third, third}) / (std::sqrt(3.0) / 2 * d * d) - 1) < 1e-6);
}

/// The ends of a drum that is wider than the box are disks as it is drawn.
BOOST_AUTO_TEST_CASE(planes_close_cylinders) {
  const double R = 0.09, pi = 3.14159265358979;
  const V middle = 0.5 * (kLow + kHigh);
  const std::vector<Wall> walls = {{Plane{kLow, {0, 1, 0}}}, {Cylinder{middle, {0, 1, 0}, R}}};
  const auto surfaces = wall_surfaces(walls, kLow, kHigh);
  BOOST_TEST(std::abs(area(surfaces[0]) / (24 * R * R * std::sin(pi / 24)) - 1) < 1e-6);
  for (const V& point : surfaces[0].points)
    BOOST_TEST(norm(cross(point - middle, V{0, 1, 0})) < R * (1 + 1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
