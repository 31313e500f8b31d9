// Fibers among meshes that turn, swing and are driven: impulses, energy, missed contacts, saved states.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/insertion/placement.hpp"
#include "tests/dem/mesh/meshes.hpp"
#include "tests/dem/walls_in_motion.hpp"

BOOST_AUTO_TEST_SUITE(mesh_mill_test)

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;
using namespace walls_in_motion;

namespace {

/// A drum of 24 sides that turns, with a paddle in it, a shaken funnel, a driven lid.
struct Mill {
  dem::Domain around;
  dem::FiberGroup fibers;

  Mill() {
    around.gravity = {0, 0.3, -g};
    around.contacts = {.restitution = 0.5, .friction = 0.35, .rolling_friction = 0.03};
    around.wall_youngs_modulus = 5e6;
    const V y{0, 1, 0};
    dem::MeshShape tube = meshes::shape_of(meshes::tube(0.02, 0.012, 24, 3)),
                   paddle_box = meshes::shape_of(meshes::box({1e-3, 6e-3, 3e-3}, 2), dem::MeshSides::one),
                   plate = meshes::shape_of(meshes::flat(0.03, 5), dem::MeshSides::one),
                   cone = meshes::shape_of(meshes::patch(20, 2, [](double u, double v) {
                     const double turned = 2 * pi * (u == 1 ? 0 : u), r = 7e-3 - 4e-3 * v;
                     return V{r * std::cos(turned), r * std::sin(turned), -4e-3 * v};
                   }));
    tube.turn(dem::rotation(V{pi / 2, 0, 0}));
    plate.turn(dem::rotation(V{pi / 2, 0, 0}));  // normal to -y
    plate.point = {0, 0.011, 0}, paddle_box.point = {0, 0, -15e-3}, cone.point = {0, 0, 14e-3};
    dem::Wall drum{tube}, left{dem::Plane{{0, -0.012, 0}, y}}, lid{plate}, paddle{paddle_box}, funnel{cone};
    drum.motion.about = left.motion.about = dem::WallAxis{{}, y};
    paddle.motion.about = dem::WallAxis{paddle.shape.point(), y};
    drum.motion.angular_velocity = left.motion.angular_velocity = 21;
    paddle.motion.angular_velocity = -9;
    funnel.motion.oscillation = dem::WallOscillation{{0.6, 0, 0.8}, 4e-4, 70, 0.3, 0.01};
    lid.motion.drive = dem::WallDrive{.axis = -y, .mass = 2e-4, .force = 3e-3, .damping = 0.01};
    around.walls = {drum, left, lid, paddle, funnel};
    fibers.chain = dem::straight_chain<3>(fiber_with(5));
    for (int n = 0; n < 12; ++n) {
      const double angle = 0.25 + 2 * pi * n / 12;
      fibers.fibers.push_back(
          dem::placed(fibers.chain,
                      {{0.0165 * std::cos(angle), -4e-3, 0.0165 * std::sin(angle)}, y, {0.1, -0.05, 0.02}}));
    }
  }

  dem::Assembly assembly(double step, bool accounted = false, int threads = 1) const {
    return {{fibers}, around, {.step = step, .threads = threads, .account_energy = accounted}};
  }
};

V momentum(const dem::Assembly& assembly) {
  V sum{};
  const double m = dem::sphere_mass(assembly.chain(0).fiber);
  for (int f = 0; f < assembly.fibers(0); ++f)
    for (const V& v : assembly.state(0, f).velocity) sum = sum + m * v;
  return sum;
}

}  // namespace

/// Impulses of all walls and the weight's are the change of momentum, in every interval; the energy closes.
BOOST_AUTO_TEST_CASE(impulses_and_work_of_meshes_are_what_fibers_get) {
  const Mill mill;
  dem::Assembly assembly = mill.assembly(4e-6, true);
  const double m = 12 * dem::fiber_mass(mill.fibers.chain.fiber), begin = total(assembly.energy());
  V before = momentum(assembly);
  double then = 0, largest = 0;
  std::vector<double> seen(mill.around.walls.size(), 0);
  for (int n = 0; n < 40; ++n) {
    assembly.march(n % 3 == 0 ? 1811 : 957);
    const double T = assembly.time() - then;
    V impulse = (m * T) * mill.around.gravity;
    double size = norm(impulse);
    const auto samples = assembly.wall_samples();
    for (std::size_t w = 0; w < samples.size(); ++w) {
      impulse = impulse - T * samples[w].mean.force;
      size += T * samples[w].force_peak;
      seen[w] = std::max(seen[w], samples[w].force_peak);
    }
    const V now = momentum(assembly);
    largest = std::max(largest, norm(now - before - impulse) / (size + m * 0.3));
    before = now, then = assembly.time();
    assembly.begin_wall_interval();
  }
  BOOST_TEST(largest < 1e-12);
  for (std::size_t w = 0; w < seen.size(); ++w) BOOST_TEST(seen[w] > 0.0, "wall " << w << " was not touched");
  const dem::EnergyBalance now = assembly.energy();
  const double given = std::abs(now.wall_work) + std::abs(now.contact_tangential);
  BOOST_TEST_MESSAGE("impulses off by " << largest << ", energy by " << (total(now) - begin) / given);
  BOOST_TEST(std::abs(total(now) - begin) < 1e-3 * given);
}

/// The contacts of every sphere are those that a look at all triangles finds, while meshes turn.
BOOST_AUTO_TEST_CASE(no_contact_with_a_mesh_is_missed) {
  Mill mill;
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
  const Mill mill;
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
  for (dem::Assembly* assembly : {&whole, &other}) assembly->march(1300);
  const auto a = whole.wall_samples(), b = other.wall_samples();
  for (std::size_t w = 0; w < a.size(); ++w) {
    for (int c = 0; c < 3; ++c) {
      BOOST_TEST(a[w].mean.force[c] == b[w].mean.force[c]);
      BOOST_TEST(a[w].mean.moment[c] == b[w].mean.moment[c]);
    }
    BOOST_TEST(a[w].work == b[w].work);
  }
  const dem::PlacedSpheres x = whole.placed(), y = other.placed();
  for (std::size_t i = 0; i < x.position.size(); ++i) {
    for (int c = 0; c < 3; ++c) BOOST_TEST_REQUIRE(x.position[i][c] == y.position[i][c]);
  }
}

/// Walls that are meshes keep the histories of their contacts when a scene goes on from a saved state.
BOOST_AUTO_TEST_CASE(contacts_with_meshes_are_taken_over) {
  const Mill mill;
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
