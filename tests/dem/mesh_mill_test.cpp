// Fibers among meshes that turn, swing and are driven: impulses, energy, missed contacts, saved states.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "tests/dem/mesh/meshes.hpp"
#include "tests/dem/mill.hpp"

BOOST_AUTO_TEST_SUITE(mesh_mill_test)

namespace dem = fiberchain::dem;
using namespace walls_in_motion;

namespace {

/// All meshes but the left end.
Mill meshed_mill() {
  const V y{0, 1, 0};
  dem::MeshShape tube = meshes::shape_of(meshes::tube(0.02, 0.012, 24, 3)),
                 paddle = meshes::shape_of(meshes::box({1e-3, 6e-3, 3e-3}, 2), dem::MeshSides::one);
  tube.turn(dem::rotation(V{pi / 2, 0, 0}));
  paddle.point = {0, 0, -15e-3};
  return Mill({.drum = {tube},
               .left = {dem::Plane{{0, -0.012, 0}, y}},
               .lid = {meshes::mill_lid()},
               .paddle = {paddle},
               .funnel = {meshes::mill_funnel()}});
}

}  // namespace

/// Impulses of all walls and the weight's are the change of momentum, in every interval; the energy closes.
BOOST_AUTO_TEST_CASE(impulses_and_work_of_meshes_are_what_fibers_get) {
  const Mill mill = meshed_mill();
  dem::Assembly assembly = mill.assembly(4e-6, true);
  const double begin = total(assembly.energy());
  march_and_weigh(mill, assembly);
  const dem::EnergyBalance now = assembly.energy();
  const double given = std::abs(now.wall_work) + std::abs(now.contact_tangential);
  BOOST_TEST_MESSAGE("energy off by " << (total(now) - begin) / given);
  BOOST_TEST(std::abs(total(now) - begin) < 1e-3 * given);
}

/// The contacts of every sphere are those that a look at all triangles finds, while meshes turn.
BOOST_AUTO_TEST_CASE(no_contact_with_a_mesh_is_missed) {
  Mill mill = meshed_mill();
  mill.around.walls[3].motion.angular_velocity = -150;
  dem::Assembly assembly = mill.assembly(3e-6);
  std::int64_t seen = 0;
  dem::MeshContactScratch all;
  for (int n = 0; n < 300; ++n) {
    assembly.march(97);
    std::vector<std::array<std::int64_t, 3>> expected, found;
    const dem::PlacedSpheres spheres = assembly.placed();
    for (std::size_t w = 0; w < assembly.walls().size(); ++w) {
      const dem::Wall& wall = assembly.walls()[w];
      const dem::MeshShape* shape = mesh_in(wall);
      if (shape == nullptr || w == 2) continue;  // the lid is open and of one side: what it held counts
      const dem::MeshShape at = moved(*shape, pose_at(wall, assembly.time()));
      std::vector<std::int32_t> triangles(at.mesh->faces());
      std::iota(triangles.begin(), triangles.end(), 0);
      for (std::size_t i = 0; i < spheres.radius.size(); ++i) {
        find_mesh_contacts(*at.mesh, at.sides, triangles, at.to_mesh(spheres.position[i]), spheres.radius[i],
                           false, all);
        for (const auto& contact : all.contacts)
          expected.push_back({static_cast<std::int64_t>(i), static_cast<std::int64_t>(w), contact.feature});
      }
    }
    for (const auto& contact : assembly.contacts()) {
      const std::int64_t w = contact.key.second.number;
      if (is_facet(contact.key.second) && w != 1 && w != 2)
        found.push_back({contact.key.first.number, w, contact.key.slot});
    }
    std::ranges::sort(expected), std::ranges::sort(found);
    BOOST_TEST((found == expected));
    seen += std::ssize(found);
  }
  BOOST_TEST(seen > 100);
}

/// A run restored amid an interval goes on to the bit; so does one on two threads.
BOOST_AUTO_TEST_CASE(restored_runs_with_meshes_go_on_to_the_bit) {
  const Mill mill = meshed_mill();
  dem::Assembly whole = mill.assembly(3e-6, true), other = mill.assembly(3e-6, true, 2);
  const auto touches_meshes = [&] {
    return std::ranges::count_if(whole.contacts(), [](const auto& c) { return c.key.slot > 0; }) > 1;
  };
  whole.march(9000);
  whole.begin_wall_interval();
  for (int n = 0; n < 200 && !touches_meshes(); ++n) whole.march(70);
  BOOST_TEST_REQUIRE(touches_meshes());
  const dem::SavedState saved = whole.saved();
  other.restore(saved);
  BOOST_TEST((other.saved() == saved));
  march_alike(whole, other, 1300);
}

/// Walls that are meshes keep the histories of their contacts when a scene goes on from a saved state.
BOOST_AUTO_TEST_CASE(contacts_with_meshes_are_taken_over) {
  const Mill mill = meshed_mill();
  dem::Assembly before = mill.assembly(3e-6);
  before.march(12000);
  const dem::CarriedState state = dem::carried_state(before.saved());
  const auto with_mesh = std::ranges::count_if(
      state.contacts, [](const auto& c) { return is_facet(c.key.second) && c.key.second.number != 1; });
  BOOST_TEST_REQUIRE(with_mesh > 2);
  for (const bool renumbered : {false, true}) {
    dem::Domain around = mill.around;
    if (renumbered) std::swap(around.walls[0], around.walls[3]);
    for (dem::Wall& wall : around.walls) {
      if (wall.motion.drive) wall.motion.drive->shift = before.walls()[2].motion.drive->shift;
    }
    dem::AssemblyOptions options{.step = 3e-6};
    options.steps_before = before.steps();
    dem::Assembly after({{mill.fibers.chain, state.groups[0].fibers}}, around, options);
    const dem::CarriedLosses losses = after.take_over(state);
    BOOST_TEST(losses.kept == losses.contacts);
  }
}

BOOST_AUTO_TEST_SUITE_END()
