// Smooth fibers among meshes that turn, swing and are driven, and solid boxes: impulses, energy, missed
// contacts, saved states.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <set>
#include <vector>

#include "dem/contact/fiber_bodies.hpp"
#include "dem/contact/ridge_contact.hpp"
#include "tests/dem/mesh/meshes.hpp"
#include "tests/dem/mill.hpp"

BOOST_AUTO_TEST_SUITE(smooth_mill_test)

namespace dem = fiberchain::dem;
using namespace walls_in_motion;

namespace {

/// A drum with ribs, a coarse paddle that turns, a lid, a shaken funnel; a solid box across the fall.
Mill ribbed_mill(double spacing) {
  const V y{0, 1, 0};
  dem::MeshShape tube = meshes::shape_of(
                     meshes::patch(1, 36,
                                   [](double u, double v) {
                                     const int n = static_cast<int>(std::lround(36 * v)) % 36;
                                     const double angle = 2 * pi * n / 36, r = n % 4 == 2 ? 0.0182 : 0.0205;
                                     return V{r * std::cos(angle), r * std::sin(angle), 0.012 * (2 * u - 1)};
                                   })),
                 paddle = meshes::shape_of(meshes::box({1e-3, 6e-3, 3e-3}), dem::MeshSides::one);
  tube.turn(dem::rotation(V{pi / 2, 0, 0}));
  paddle.point = {0, 0, -12.5e-3};
  dem::Wall block{dem::BoxObstacle{{6e-3, 1e-3, 2e-3}, {4e-3, 3e-3, 1e-3}, {0.8, 0, 0.6}, {0, 1, 0}}};
  block.motion.about = dem::WallAxis{{6e-3, 0, 2e-3}, {0, 0.6, 0.8}};
  block.motion.angular_velocity = 13;
  Mill mill({.drum = {tube},
             .left = {dem::Plane{{0, -0.012, 0}, y}},
             .lid = {meshes::mill_lid()},
             .paddle = {paddle},
             .funnel = {meshes::mill_funnel()},
             .more = {block}});
  dem::Fiber fiber = fiber_with(spacing > 1 ? 3 : 5, 2.6e7);
  fiber.spacing = spacing;
  mill.fibers.chain = dem::straight_chain<3>(fiber);
  mill.fibers.chain.smooth = true;
  mill.fibers.fibers.clear();
  for (int n = 0; n < 12; ++n) {
    const double angle = -1 + 5.14 * n / 11, r = n % 3 == 1 ? 0.0125 : 0.014;
    mill.fibers.fibers.push_back(
        dem::placed(mill.fibers.chain, {{r * std::cos(angle), -4e-3, r * std::sin(angle)},
                                        {0.3 * std::sin(angle), 0.8, 0.2},
                                        {0.1, -0.05, 0.02}}));
  }
  return mill;
}

}  // namespace

BOOST_AUTO_TEST_CASE(impulses_and_work_are_what_smooth_fibers_get) {
  const Mill mill = ribbed_mill(1);
  dem::Assembly assembly = mill.assembly(2e-6, true);
  const double begin = total(assembly.energy());
  march_and_weigh(mill, assembly);
  const dem::EnergyBalance now = assembly.energy();
  const double given =
      std::abs(now.wall_work) + now.contact_tangential + now.contact_normal + now.bond_damping;
  BOOST_TEST_MESSAGE("energy off by " << (total(now) - begin) / given << " of " << given << " J, walls "
                                      << now.wall_work << " J");
  // shares at ridges have no potential: at other steps, where the motion is another one, 7e-4 to 1e-3
  BOOST_TEST(std::abs(total(now) - begin) < 2e-3 * given);
}

namespace {

/// What every segment touches of every edge of a wall, the nodes' contacts being those of the assembly.
void find_all(const dem::Assembly& assembly, std::size_t w, const dem::MeshShape& at,
              std::set<dem::ContactKey>& keys) {
  const dem::TriangleMesh& mesh = *at.mesh;
  const dem::MeshRidges ridges = ridges_of(mesh);
  std::vector<std::int32_t> edges;
  for (std::int32_t e = 0; e < std::ssize(mesh.edges); ++e) {
    if (ridges.is_ridge[e] != 0) edges.push_back(e);
  }
  dem::FiberBodies bodies;
  bodies.add(assembly.chain(0), assembly.fibers(0));
  bodies.build(0);
  const dem::PlacedSpheres spheres = assembly.placed();
  const auto position = [&](std::int64_t i) {
    return at.to_mesh(spheres.position[static_cast<std::size_t>(i)]);
  };
  std::vector<std::int32_t> triangles(mesh.faces());
  std::iota(triangles.begin(), triangles.end(), 0);
  const auto near = [&](std::int64_t node) {
    std::vector<dem::NodeContact> all;
    dem::MeshContactScratch scratch;
    const double reach = spheres.radius[static_cast<std::size_t>(node)] + 0.2 * bodies.largest_bound();
    find_mesh_contacts(mesh, at.sides, triangles, position(node), reach, false, scratch);
    for (const auto& c : scratch.contacts)
      all.push_back({c.feature, c.direction, position(node) + c.distance * c.direction, c.distance});
    return all;
  };
  std::vector<dem::RidgePoint> points;
  for (std::int64_t i = 0; i < std::ssize(spheres.position); ++i) {
    if (bodies.is_none(i)) continue;
    const auto segment = bodies.nodes(i, position);
    find_ridge_points(mesh, ridges, at.sides, edges, segment, segment.radius, points);
    auto begin = near(i), end = near(i + 1);
    share_out(mesh, segment, {begin, end}, points);
    for (const auto& p : points) {
      if (p.share >= dem::least_share)
        keys.insert(
            {dem::segment_primitive(i), dem::facet_primitive(static_cast<std::int64_t>(w)), p.feature});
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_contact_with_a_ridge_is_missed) {
  Mill mill = ribbed_mill(1.7);
  mill.around.walls[3].motion.angular_velocity = -150;
  dem::Assembly assembly = mill.assembly(2e-6);
  std::size_t seen = 0;
  for (int n = 0; n < 300; ++n) {
    assembly.march(97);
    std::set<dem::ContactKey> expected, found;
    for (const std::size_t w : {0u, 3u, 4u}) {
      const dem::Wall& wall = assembly.walls()[w];
      find_all(assembly, w, moved(*mesh_in(wall), pose_at(wall, assembly.time())), expected);
    }
    for (const auto& c : assembly.contacts()) {
      if (is_facet(c.key.second) && !is_sphere(c.key.first) && c.key.second.number < 5) found.insert(c.key);
    }
    BOOST_TEST((found == expected), "moment " << n << ": " << found.size() << ", " << expected.size());
    seen += found.size();
  }
  BOOST_TEST_MESSAGE(seen << " contacts compared");
  BOOST_TEST(seen > 50u);
}

BOOST_AUTO_TEST_CASE(restored_runs_with_ridges_go_on_to_the_bit) {
  const Mill mill = ribbed_mill(1.7);
  dem::Assembly whole = mill.assembly(2e-6, true), other = mill.assembly(2e-6, true, 2);
  const auto on_ridges = [&] {
    return std::ranges::count_if(
        whole.contacts(), [](const auto& c) { return is_facet(c.key.second) && !is_sphere(c.key.first); });
  };
  whole.march(9000);
  whole.begin_wall_interval();
  for (int n = 0; n < 400 && on_ridges() < 2; ++n) whole.march(70);
  BOOST_TEST_REQUIRE(on_ridges() >= 2);
  const dem::SavedState saved = whole.saved();
  other.restore(saved);
  BOOST_TEST((other.saved() == saved));
  march_alike(whole, other, 1300);
}

/// Walls keep the histories of what segments touch when a scene goes on from a saved state.
BOOST_AUTO_TEST_CASE(contacts_with_ridges_are_taken_over) {
  const Mill mill = ribbed_mill(1.7);
  dem::Assembly before = mill.assembly(2e-6);
  std::ptrdiff_t on_ridges = 0;
  dem::CarriedState state;
  for (int n = 0; n < 400 && on_ridges < 2; ++n) {
    before.march(n == 0 ? 9000 : 70);
    state = dem::carried_state(before.saved());
    on_ridges = std::ranges::count_if(state.contacts, [](const auto& c) {
      return is_facet(c.key.second) && c.key.first.kind == dem::PrimitiveKind::segment;
    });
  }
  BOOST_TEST_REQUIRE(on_ridges >= 2);
  dem::Domain around = mill.around;
  around.walls[2].motion.drive->shift = before.walls()[2].motion.drive->shift;
  dem::AssemblyOptions options{.step = 2e-6};
  options.steps_before = before.steps();
  dem::Assembly after({{mill.fibers.chain, state.groups[0].fibers}}, around, options);
  const dem::CarriedLosses losses = after.take_over(state);
  BOOST_TEST(losses.kept == losses.contacts);
}

BOOST_AUTO_TEST_SUITE_END()
