// Contacts of spheres with meshes: closest points and the search against brute force, a box of triangles
// against the box obstacle, faces, edges and corners once each.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "dem/model/shapes/box.hpp"
#include "tests/dem/mesh/meshes.hpp"

BOOST_AUTO_TEST_SUITE(mesh_contact_test)

using namespace meshes;

namespace {

std::vector<V> random_places(int count, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<V> all;
  for (int n = 0; n < count; ++n) all.push_back({number(random), number(random), number(random)});
  return all;
}

/// Distance of a triangle by minimizing over its points, which are a + u (b - a) + v (c - a): a projected
/// gradient descent, which knows nothing of features.
double distance_by_descent(const dem::TriangleMesh& mesh, std::int32_t t, const V& from) {
  const auto& [a, b, c] = mesh.triangles[t];
  const V origin = mesh.vertices[a], p = mesh.vertices[b] - origin, q = mesh.vertices[c] - origin;
  double u = 1.0 / 3, v = 1.0 / 3;
  const double rate = 1 / (dot(p, p) + dot(q, q));
  for (int n = 0; n < 3000; ++n) {
    const V off = origin + u * p + v * q - from;
    u -= rate * dot(off, p), v -= rate * dot(off, q);
    // back into the triangle
    if (u + v > 1) {
      const double over = (u + v - 1) / 2;
      u -= over, v -= over;
      if (u < 0) u = 0, v = 1;
      if (v < 0) v = 0, u = 1;
    }
    u = std::clamp(u, 0.0, 1.0), v = std::clamp(v, 0.0, 1.0 - u);
  }
  return norm(origin + u * p + v * q - from);
}

std::vector<dem::MeshContact> contacts_of(const dem::TriangleMesh& mesh, const V& center, double reach,
                                          dem::MeshSides sides = dem::MeshSides::both, bool held = false) {
  std::vector<std::int32_t> all(mesh.faces());
  std::iota(all.begin(), all.end(), 0);
  dem::MeshContactScratch found;
  dem::find_mesh_contacts(mesh, sides, all, center, reach, held, found);
  return found.contacts;
}

}  // namespace

BOOST_AUTO_TEST_CASE(closest_points_are_the_nearest_of_all) {
  const dem::TriangleMesh mesh = *mesh_of(flat(1.3, 3));
  dem::TriangleSoup odd;
  add_triangle(odd, {0.1, 0.2, -0.3}, {1.7, 0.4, 0.2}, {0.5, 0.9, 0.8});
  add_triangle(odd, {0.1, 0.2, -0.3}, {0.5, 0.9, 0.8}, {-1.1, 0.4, 0.2});
  const dem::TriangleMesh leaning = *mesh_of(odd);
  double largest = 0;
  int faces = 0, edges = 0, corners = 0;
  for (const V& from : random_places(160, 2, 5)) {
    for (std::int32_t t = 0; t < leaning.faces(); ++t) {
      const dem::ClosestPoint closest = closest_point(leaning, t, from);
      largest =
          std::max(largest, std::abs(std::sqrt(closest.squared) - distance_by_descent(leaning, t, from)));
      BOOST_TEST(std::abs(norm(closest.to) - std::sqrt(closest.squared)) < 1e-14);
      faces += leaning.kind_of(closest.feature) == dem::FeatureKind::face ? 1 : 0;
      edges += leaning.kind_of(closest.feature) == dem::FeatureKind::edge ? 1 : 0;
      corners += leaning.kind_of(closest.feature) == dem::FeatureKind::corner ? 1 : 0;
    }
  }
  BOOST_TEST(largest < 1e-9);
  BOOST_TEST(std::min({faces, edges, corners}) > 10);
}

/// Triangles near a place, and the nearest one, are those that a look at every one finds.
BOOST_AUTO_TEST_CASE(the_search_finds_what_brute_force_finds) {
  dem::TriangleSoup soup = flat(1.1, 17);
  std::mt19937 random(11);
  std::normal_distribution<double> height(0, 0.2);
  for (V& x : soup.vertices) x[2] = 0.3 * std::sin(5 * x[0]) + 0.2 * x[1];
  for (int n = 0; n < 40; ++n) {
    const V at{height(random), height(random), 1 + height(random)};
    add_triangle(soup, at, at + V{0.1, 0, height(random)}, at + V{0, 0.1, height(random)});
  }
  const dem::TriangleMesh mesh = *mesh_of(soup);
  std::size_t seen = 0;
  for (const V& from : random_places(300, 1.5, 8)) {
    const double reach = 0.23;
    std::vector<std::int32_t> expected, found;
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t t = 0; t < mesh.faces(); ++t) {
      const double squared = closest_point(mesh, t, from).squared;
      least = std::min(least, squared);
      if (squared < reach * reach) expected.push_back(t);
    }
    mesh.search.near(from, reach, [&](std::int32_t t) {
      if (closest_point(mesh, t, from).squared < reach * reach) found.push_back(t);
    });
    std::ranges::sort(found);
    BOOST_TEST((found == expected));
    BOOST_TEST(nearest_point(mesh, from).squared == least);
    seen += found.size();
  }
  BOOST_TEST(seen > 500u);
}

/// Outside, a box touches in one point, the obstacle's; so it does a little inside.
BOOST_AUTO_TEST_CASE(a_box_of_triangles_is_the_box_obstacle) {
  const V half{0.7, 1.1, 0.4};
  const dem::BoxObstacle obstacle{{}, half, {1, 0, 0}, {0, 1, 0}};
  for (const int cells : {1, 3}) {
    const dem::TriangleMesh mesh = *mesh_of(box(half, cells));
    BOOST_TEST(mesh.is_closed);
    const dem::MeshShape shape{.mesh = mesh_of(box(half, cells)), .sides = dem::MeshSides::one};
    int kinds[3] = {}, inside = 0;
    for (const V& from : random_places(4000, 1.6, 21)) {
      const dem::NearestPoint<double> expected = obstacle.nearest(from);
      if (expected.distance < -0.2) continue;
      const dem::NearestPoint<double> nearest = shape.nearest(from);
      BOOST_TEST(std::abs(nearest.distance - expected.distance) < 2e-15);
      const auto contacts = contacts_of(mesh, from, 2.5, dem::MeshSides::one);
      BOOST_TEST_REQUIRE(contacts.size() == 1u);
      BOOST_TEST(std::abs(contacts[0].distance - expected.distance) < 2e-15);
      BOOST_TEST(norm(contacts[0].direction - expected.direction) <
                 1e-13 / (0.01 + std::abs(expected.distance)));
      ++kinds[static_cast<int>(mesh.kind_of(contacts[0].feature))];
      inside += expected.distance < 0 ? 1 : 0;
    }
    for (const int count : kinds) BOOST_TEST(count > 20);
    BOOST_TEST(inside > 20);
  }
}

/// In a flat place every sphere has one contact, over faces, edges and corners alike; right above those, too.
BOOST_AUTO_TEST_CASE(a_flat_place_is_touched_once) {
  const dem::TriangleMesh mesh = *mesh_of(flat(1.3, 6));
  std::vector<V> feet;
  for (V x : random_places(500, 1.0, 4)) feet.push_back({x[0], x[1], 0});
  for (const dem::MeshEdge& edge : mesh.edges) {
    feet.push_back(mesh.vertices[edge.low]);
    for (const double share : {0.25, 1.0 / 3, 0.71})
      feet.push_back(mesh.vertices[edge.low] + share * (mesh.vertices[edge.high] - mesh.vertices[edge.low]));
  }
  for (const V& foot : feet) {
    for (const double height : {0.8, -0.05, 1e-9}) {
      const auto contacts = contacts_of(mesh, foot + V{0, 0, height}, 1);
      BOOST_TEST_REQUIRE(contacts.size() == 1u);
      BOOST_TEST(std::abs(contacts[0].distance - std::abs(height)) < 1e-15);
      BOOST_TEST(std::abs(contacts[0].direction[2] + (height > 0 ? 1 : -1)) < 1e-7);
    }
  }
}

/// What a flat place tells without a look at the mesh is what a look finds, to the bit, wherever the center
/// goes within the margin: on plane, convex, concave and rough surfaces of triangles smaller than the sphere.
BOOST_AUTO_TEST_CASE(flat_places_tell_what_a_look_finds) {
  const auto wavy = [](double height) {
    return patch(9, 9, [=](double u, double v) {
      return V{2 * u - 1, 2 * v - 1, height * std::sin(9 * u + 4 * v) * std::cos(7 * v)};
    });
  };
  const std::vector<dem::TriangleSoup> surfaces{
      flat(1.3, 6), box({1, 0.8, 0.9}, 3), tube(1, 1, 72, 9), tube(0.8, 1, 12, 4), wavy(0.01), wavy(0.2)};
  std::vector<double> told;
  for (const dem::TriangleSoup& soup : surfaces) {
    const dem::TriangleMesh mesh = *mesh_of(soup);
    const double reach = 0.3, listed = 1.3 * reach;
    int flat_ones = 0, near = 0;
    for (const V& center : random_places(6000, 1.2, 17)) {
      const double distance = norm(dem::nearest_point(mesh, center).to);
      if (distance > reach || distance < 0.93 * reach) continue;
      ++near;
      std::vector<std::int32_t> inner;
      for (std::int32_t t = 0; t < mesh.faces(); ++t) {
        if (dem::closest_point(mesh, t, center).squared < listed * listed) inner.push_back(t);
      }
      const dem::FlatPlace place = dem::flat_place(mesh, inner, center, reach, listed - reach);
      if (place.margin == 0) continue;
      for (const V& way : random_places(30, place.margin / std::sqrt(3.0), static_cast<unsigned>(near))) {
        for (const dem::MeshSides sides : {dem::MeshSides::both, dem::MeshSides::one}) {
          const V there = center + way;
          const double height = dem::height_over(place, there);
          if (!dem::is_told_by(place, sides, height, reach)) continue;
          ++flat_ones;
          dem::MeshContactScratch found;
          dem::find_mesh_contacts(mesh, sides, inner, there, reach, false, found);
          BOOST_TEST_REQUIRE(found.contacts.size() == (std::abs(height) < reach ? 1u : 0u));
          if (found.contacts.empty()) continue;
          const dem::MeshContact own = dem::contact_at(place, height);
          BOOST_TEST(own.feature == found.contacts[0].feature);
          BOOST_TEST(own.distance == found.contacts[0].distance);
          for (int c = 0; c < 3; ++c) BOOST_TEST(own.direction[c] == found.contacts[0].direction[c]);
        }
      }
    }
    told.push_back(flat_ones / (60.0 * near));
  }
  BOOST_TEST(told[0] > 0.25);
  for (const double share : told) BOOST_TEST(share > 0.02);
}

/// A notch bent by much is touched on both sides, one bent by little where it is nearest.
BOOST_AUTO_TEST_CASE(concave_edges_are_touched_by_both_faces) {
  for (const double bend : {1.2, 0.6, 0.1, 1e-4}) {
    const V left{-std::cos(bend / 2), 0, std::sin(bend / 2)},
        right{std::cos(bend / 2), 0, std::sin(bend / 2)};
    const dem::TriangleMesh mesh = *mesh_of(patch(2, 2, [&](double u, double v) {
      const V out = u < 0.5 ? (1 - 2 * u) * left : (2 * u - 1) * right;
      return V{out[0], 2 * v - 1, out[2]};
    }));
    const V center{0.01, 0.1, 0.3};
    const auto contacts = contacts_of(mesh, center, 0.4);
    const double on_right = -center[0] * std::sin(bend / 2) + center[2] * std::cos(bend / 2),
                 on_left = center[0] * std::sin(bend / 2) + center[2] * std::cos(bend / 2);
    const bool sharp = bend > 0.35;
    BOOST_TEST_REQUIRE(contacts.size() == (sharp ? 2u : 1u));
    double least = 1, most = 0;
    for (const auto& contact : contacts)
      least = std::min(least, contact.distance), most = std::max(most, contact.distance);
    BOOST_TEST(std::abs(least - on_right) < 1e-15);
    if (sharp) BOOST_TEST(std::abs(most - on_left) < 1e-15);
  }
  const dem::TriangleMesh corner = *mesh_of(box({1, 1, 1}));
  BOOST_TEST(contacts_of(corner, {0.8, -0.75, 0.9}, 0.3).size() == 3u);
  BOOST_TEST(contacts_of(corner, {0.8, -0.75, 0.9}, 0.22).size() == 2u);
  BOOST_TEST(contacts_of(corner, {0.8, -0.75, 0.9}, 0.12).size() == 1u);
}

/// An open sheet of one side is there from outside, and holds what it has held.
BOOST_AUTO_TEST_CASE(a_sheet_of_one_side_is_passed_from_behind) {
  const dem::TriangleMesh sheet = *mesh_of(flat(1, 4));
  const V above{0.13, 0.2, 0.05}, below{0.13, 0.2, -0.05}, beside{1.05, 0.2, -0.02};
  BOOST_TEST(contacts_of(sheet, above, 0.1, dem::MeshSides::one).size() == 1u);
  BOOST_TEST(contacts_of(sheet, below, 0.1, dem::MeshSides::one).empty());
  const auto held = contacts_of(sheet, below, 0.1, dem::MeshSides::one, true);
  BOOST_TEST_REQUIRE(held.size() == 1u);
  BOOST_TEST(held[0].distance == -0.05);
  BOOST_TEST(held[0].direction[2] == -1.0);
  BOOST_TEST(contacts_of(sheet, below, 0.1).size() == 1u);
  const auto rim = contacts_of(sheet, beside, 0.1, dem::MeshSides::one);
  BOOST_TEST_REQUIRE(rim.size() == 1u);
  BOOST_TEST(std::abs(rim[0].distance - std::hypot(0.05, 0.02)) < 1e-15);
}

/// Corners that do not meet, triangles listed twice and slits of round-off change nothing.
BOOST_AUTO_TEST_CASE(torn_meshes_are_touched_once) {
  dem::TriangleSoup torn;
  add_quad(torn, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
  for (int n = 0; n < 4; ++n) {  // finer on the other side, a slit of 1e-12 between
    const double low = -1 + 0.5 * n;
    add_quad(torn, {1e-12, low, 0}, {1, low, 0}, {1, low + 0.5, 0}, {1e-12, low + 0.5, 0});
  }
  add_triangle(torn, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0});
  const dem::TriangleMesh mesh = *mesh_of(torn);
  for (const V& x : random_places(400, 0.9, 31)) {
    for (const double at : {x[0], 1e-3 * x[0], 1e-12 * x[0]}) {
      const auto contacts = contacts_of(mesh, {at, x[1], 0.97}, 1);
      BOOST_TEST_REQUIRE(contacts.size() == 1u);
      BOOST_TEST(std::abs(contacts[0].distance - 0.97) < 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_way_through_a_mesh_is_seen) {
  dem::Wall wall{shape_of(flat(1, 5))};
  wall.velocity = {0, 0, 0.5};
  BOOST_TEST(passes_through(wall, {0.3, 0.2, -0.1}, {0.3, 0.25, 0.1}, 0));
  BOOST_TEST(!passes_through(wall, {0.3, 0.2, -0.1}, {0.3, 0.25, 0.1}, 1));
  BOOST_TEST(passes_through(wall, {0.3, 0.2, 0.4}, {0.3, 0.25, 0.6}, 1));
  BOOST_TEST(!passes_through(wall, {1.3, 0.2, -0.1}, {1.3, 0.25, 0.1}, 0));
  BOOST_TEST(!passes_through(dem::Wall{dem::Plane{{}, {0, 0, 1}}}, {0, 0, -1}, {0, 0, 1}, 0));
}

BOOST_AUTO_TEST_SUITE_END()
