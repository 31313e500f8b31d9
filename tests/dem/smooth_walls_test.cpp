// Smooth fibers at walls with edges, meshes and solid boxes, touched between the nodes.
#include <algorithm>
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "dem/contact/ridge_contact.hpp"
#include "dem/insertion/placement.hpp"
#include "tests/dem/mesh/meshes.hpp"
#include "tests/dem/walls_in_motion.hpp"

BOOST_AUTO_TEST_SUITE(smooth_walls_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;
using namespace walls_in_motion;

namespace {

constexpr double kRadius = 0.83e-3, kFriction = 0.3;

dem::Chain<3> rod(int bonds, double spacing) {
  dem::Fiber fiber{dem::isotropic_material(2.6e7, 0.17, 1130), 2 * kRadius, bonds};
  fiber.bond_damping = 0.1;
  fiber.spacing = spacing;
  dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  chain.smooth = true;
  return chain;
}

/// A ridge along y at the height 0, its sides falling by this angle, its edge in pieces; or that of a box.
dem::Wall ridge(double slope, bool solid) {
  if (solid) {
    const double a = 0.02, s = std::sqrt(0.5);
    return {dem::BoxObstacle{{0, 0, -a / s}, {a, 0.05, a}, {s, 0, s}, {0, 1, 0}}};
  }
  return {meshes::shape_of(meshes::patch(2, 13, [&](double u, double v) {
    const double x = 0.04 * (u - 0.5);
    return V{x, 0.1 * (v - 0.437), -std::tan(slope) * std::abs(x)};
  }))};
}

dem::Domain around(const dem::Wall& wall) {
  dem::Domain domain;
  domain.walls = {wall};
  domain.contacts = {0.4, kFriction, 0};
  domain.wall_youngs_modulus = 7e6;
  return domain;
}

std::vector<dem::SphereAddress> all_spheres(int spheres) {
  std::vector<dem::SphereAddress> all;
  for (int i = 0; i < spheres; ++i) all.push_back({0, 0, i});
  return all;
}

V on_wall(const dem::Assembly& assembly) {
  V force{};
  for (const dem::ContactState& c : assembly.contact_forces()) force = force - c.force;
  return force;
}

/// Hertz's force of a sphere of the rod on the wall.
double hertz(double overlap) {
  const double flat = 1 / ((1 - 0.17 * 0.17) / 2.6e7 + (1 - 0.3 * 0.3) / 7e6);
  return 4.0 / 3 * flat * std::sqrt(kRadius) * std::pow(overlap, 1.5);
}

}  // namespace

BOOST_AUTO_TEST_CASE(smooth_fibers_move_on_flat_triangles_as_on_a_plane) {
  const dem::MeshShape mesh = meshes::shape_of(meshes::flat(0.03, 9));
  for (const double spacing : {1.0, 2.5}) {
    const dem::Chain<3> chain = rod(spacing > 1 ? 3 : 7, spacing);
    dem::ChainState<3> state =
        dem::placed(chain, {{-8e-3, 2e-3, 1.7 * kRadius}, {0.6, 0.8, 0.02}, {0.3, -0.1, -0.3}});
    const auto on = [&](const dem::WallShape& shape) {
      dem::Domain domain = around({shape});
      domain.gravity = {0.5, 0, -g};
      return dem::Assembly({{chain, {state}}}, domain, {.step = 2e-6});
    };
    dem::Assembly exact = on(dem::Plane{{0, 0, 0}, {0, 0, 1}}), meshed = on(mesh);
    double off = 0;
    for (int n = 0; n < 60; ++n) {
      exact.march(300), meshed.march(300);
      off = std::max(off, norm(exact.state(0, 0).poses[2].position - meshed.state(0, 0).poses[2].position));
      BOOST_TEST(exact.touching() == meshed.touching());
    }
    BOOST_TEST(off < 1e-9 * kRadius);
    BOOST_TEST(norm(exact.state(0, 0).poses[0].position - state.poses[0].position) > 3 * kRadius);
  }
}

/// Balanced on a ridge in the middle of a segment three diameters long, whose nodes touch nothing.
BOOST_DATA_TEST_CASE(a_rod_rests_across_a_ridge, boost::unit_test::data::make({false, true}), solid) {
  const dem::Chain<3> chain = rod(5, 3);
  const double weight = dem::fiber_mass(chain.fiber) * g;
  dem::Domain domain = around(ridge(0.7, solid));
  domain.gravity = {0, 0, -g};
  const V along = {0.8, 0.6, 0};
  const double overlap = std::pow(weight / hertz(1), 2.0 / 3);
  dem::Assembly assembly(
      {{chain,
        {dem::placed(chain, {V{0, 0, kRadius - 0.9 * overlap} - 7.5 * 2 * kRadius * along, along, {}})}}},
      domain, {.step = 2e-6});
  assembly.march(200000, dem::ContactForces::kept);
  const auto contacts = assembly.contact_forces();
  BOOST_TEST_REQUIRE(contacts.size() == 1u);
  BOOST_TEST_MESSAGE("overlap " << contacts[0].overlap / overlap << " of Hertz's");
  BOOST_TEST(std::abs(contacts[0].overlap / overlap - 1) < 5e-3);
  BOOST_TEST(norm(contacts[0].point) < 1e-2 * kRadius);
  BOOST_TEST(contacts[0].normal[2] < -1 + 1e-6);
  BOOST_TEST((contacts[0].key.first == dem::segment_primitive(2)));
}

namespace {

struct Passage {
  double least = 1e9, most = 0;  ///< normal force over Hertz's
  double friction = 0;           ///< largest departure of friction over normal force from its coefficient
  int contacts = 0;              ///< at once, at most
  bool crossed = false, at_node = false;
};

/// A rod that is held level and drawn along itself over a ridge, under an angle to it.
Passage draw(double slope, bool solid, double angle, double spacing,
             dem::InstructionSet set = dem::best_instruction_set()) {
  const dem::Chain<3> chain = rod(spacing > 1 ? 5 : 9, spacing);
  const double length = chain.fiber.aspect_ratio * spacing * 2 * kRadius, overlap = 0.002 * kRadius,
               speed = 0.2;
  const V along{std::sin(angle), std::cos(angle), 0};
  dem::Grip carriage;
  carriage.place = carriage.turn = {true, true, true};
  carriage.spheres = all_spheres(chain.fiber.aspect_ratio + 1);
  carriage.body.velocity = speed * along;
  dem::ChainState<3> state =
      dem::placed(chain, {V{0, 0, kRadius - overlap} - 0.7 * length * along, along, speed * along});
  dem::Assembly assembly({{chain, {state}}}, around(ridge(slope, solid)),
                         {.step = 2e-6, .instruction_set = set, .grips = {carriage}});
  Passage passage;
  const int samples = 400, steps = static_cast<int>(0.4 * length / speed / assembly.step() / samples);
  for (int n = 0; n < samples; ++n) {
    assembly.march(steps, dem::ContactForces::kept);
    const V force = on_wall(assembly);
    const auto contacts = assembly.contact_forces();
    for (const auto& c : contacts) (is_sphere(c.key.first) ? passage.at_node : passage.crossed) = true;
    passage.contacts = std::max(passage.contacts, static_cast<int>(contacts.size()));
    const double normal = -force[2] / hertz(overlap), friction = dot(force, along) / -force[2];
    passage.least = std::min(passage.least, normal), passage.most = std::max(passage.most, normal);
    if (n > 20) passage.friction = std::max(passage.friction, std::abs(friction / kFriction - 1));
  }
  return passage;
}

}  // namespace

/// The same force whether the ridge is under a segment or a node.
BOOST_AUTO_TEST_CASE(a_rod_drawn_over_a_ridge_meets_one_contact_and_no_bump) {
  for (const bool solid : {false, true}) {
    for (const double angle : {1.5707963, 0.6}) {
      for (const double spacing : {1.0, 2.5}) {
        const Passage passage = draw(0.3, solid, angle, spacing);
        BOOST_TEST_MESSAGE((solid ? "box, " : "mesh, ")
                           << "angle " << angle << ", spacing " << spacing << ": normal force "
                           << passage.least << " to " << passage.most << ", friction off by "
                           << passage.friction << ", " << passage.contacts << " contacts");
        BOOST_TEST(passage.crossed);
        BOOST_TEST(passage.at_node);
        BOOST_TEST(passage.least > 1 - 1e-5);
        BOOST_TEST(passage.most < 1 + 1e-5);
        BOOST_TEST(passage.friction < 1e-9);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(every_instruction_set_has_the_same_forces_at_ridges) {
  const Passage scalar = draw(0.3, false, 0.6, 1, dem::InstructionSet::scalar),
                wide = draw(0.3, false, 0.6, 1);
  BOOST_TEST(std::abs(scalar.least - wide.least) < 1e-12);
  BOOST_TEST(std::abs(scalar.most - wide.most) < 1e-12);
  BOOST_TEST(scalar.contacts == wide.contacts);
}

namespace {

/// Force of a long rod across a tube of n facets from outside over that on the cylinder, mean square
/// departure from 1 over places of the facets under it.
double departure(int n) {
  const double rho = 7.3, R = 1.3, overlap = 0.02;
  const dem::MeshShape shape = meshes::shape_of(meshes::tube(rho, 4, n, 1));
  const dem::TriangleMesh& mesh = *shape.mesh;
  const dem::MeshRidges ridges = ridges_of(mesh);
  std::vector<std::int32_t> edges;
  for (std::int32_t e = 0; e < std::ssize(mesh.edges); ++e) {
    if (ridges.is_ridge[e] != 0) edges.push_back(e);
  }
  double sum = 0;
  std::vector<dem::RidgePoint> points;
  for (int k = 0; k < 50; ++k) {
    const double turned = 2 * pi / n * (k + 0.5) / 50;
    const V out{std::cos(turned), std::sin(turned), 0}, along{-std::sin(turned), std::cos(turned), 0};
    const V middle = (rho + R - overlap) * out + V{0, 0, 0.4}, begin = middle - 6.1 * along,
            end = middle + 5.7 * along;
    const dem::SegmentNodes<double> segment{begin, begin, end, end, R};
    find_ridge_points(mesh, ridges, dem::MeshSides::both, edges, segment, R, points);
    share_out(mesh, segment, {}, points);
    V force{};
    for (const auto& p : points)
      force = force + p.share * std::pow((R - p.distance) / overlap, 1.5) * p.direction;
    sum += dot(force + out, force + out) / 50;
  }
  return std::sqrt(sum);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_tube_of_triangles_comes_to_be_the_cylinder_in_second_order) {
  const double coarse = departure(400), fine = departure(800), finest = departure(1600);
  BOOST_TEST_MESSAGE("off by " << coarse << ", " << fine << ", " << finest);
  BOOST_TEST(std::abs(std::log2(coarse / fine) - 2) < 0.05);
  BOOST_TEST(std::abs(std::log2(fine / finest) - 2) < 0.05);
  BOOST_TEST(finest < 6e-4);
}

BOOST_AUTO_TEST_SUITE_END()
