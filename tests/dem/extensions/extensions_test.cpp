// A further contact law and a further wall shape, each a header and a line, run in assemblies.
#define BOOST_TEST_MODULE extensions
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "dem/contact/contact_law.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/extensions/lists.hpp"
#include "tests/dem/small_packing.hpp"

using namespace scenes;

namespace {

const dem::ContactLaw& linear_contact =
    dem::contact_law_of<extensions::LinearContact, extensions::MoreLaws, dem::WallShapes>;
const dem::ContactLaw& hertz_on_spheres =
    dem::contact_law_of<dem::HertzMindlin, dem::ContactLaws, extensions::MoreShapes>;

/// Two spheres abreast, joined by a bond that carries nothing.
const dem::Fiber ball{dem::isotropic_material(2.6e6, 0.31, 1130), 1.66e-3, 1};
const double R = dem::sphere_radius(ball), m = dem::sphere_mass(ball);

dem::FiberGroup moving(const V& place, const V& axis, const V& velocity) {
  const dem::Chain<3> chain = dem::straight_chain<3>(ball);
  return {chain, {dem::placed(chain, {place, axis, velocity})}};
}

double largest_off(dem::Assembly& assembly, int moments, int steps) {
  const dem::EnergyBalance start = assembly.energy();
  double off = 0;
  for (int n = 0; n < moments; ++n) {
    assembly.march(steps);
    const dem::EnergyBalance now = assembly.energy();
    off = std::max(off, std::abs(total(now) - total(start)) /
                            (start.kinetic + start.gravity - now.gravity + now.wall_work));
  }
  return off;
}

}  // namespace

BOOST_AUTO_TEST_CASE(linear_springs_collide_in_half_a_period_whatever_the_speed) {
  for (const double e : {1.0, 0.6, 0.2}) {
    for (const double speed : {0.01, 0.5}) {
      dem::Domain around;
      around.contacts = {.restitution = e, .law = &linear_contact};
      // E* = E / (2 (1 - nu^2)), R* = R / 2, m* = m / 2
      const double k = 2.6e6 / 2 / (1 - 0.31 * 0.31) * R / 2, l = std::log(e), pi = std::numbers::pi;
      const double time = std::sqrt(m / 2 / k * (pi * pi + l * l)), dt = time / 4000;
      dem::Assembly assembly(
          {moving({}, {0, 0, 1}, {}), moving({2 * R + 0.4 * dt * speed, 0, 0}, {0, 0, 1}, {-speed, 0, 0})},
          around, {.step = dt, .account_energy = true});
      int touching = 0;
      for (int n = 0; n < 4400; ++n) assembly.march(1), touching += assembly.touching() > 0;
      const double first = assembly.state(0, 0).velocity[0][0], second = assembly.state(1, 0).velocity[0][0];
      BOOST_TEST(touching * dt == time, boost::test_tools::tolerance(2e-3));
      BOOST_TEST((second - first) / speed == e, boost::test_tools::tolerance(2e-3));
      BOOST_TEST(first + second == -speed, boost::test_tools::tolerance(1e-9));
      const double lost = 0.5 * m * speed * speed * (1 - e * e);  // 1/2 m* v^2 (1 - e^2) of each of two pairs
      BOOST_TEST(std::abs(assembly.energy().contact_normal - lost) < 5e-3 * 0.5 * m * speed * speed);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_balance_of_a_packing_with_linear_springs_closes) {
  for (const auto set : {dem::InstructionSet::scalar, dem::best_instruction_set()}) {
    SmallPacking packing = packing_in_a_box(12, 9);
    packing.around.contacts = {.restitution = 0.6, .friction = 0.4, .law = &linear_contact};
    dem::Assembly assembly = packing.assembly({.account_energy = true, .instruction_set = set});
    BOOST_TEST(largest_off(assembly, 10, 300) < 5e-3);
    BOOST_TEST(assembly.touching() > 2);
    BOOST_TEST(assembly.energy().contact_normal > 0);
    BOOST_TEST(assembly.energy().contact_tangential > 0);
    const auto saved = assembly.saved();
    dem::Assembly again = packing.assembly({.account_energy = true, .instruction_set = set});
    again.restore(saved);
    assembly.march(50), again.march(50);
    BOOST_TEST((numbers(assembly) == numbers(again)));
  }
}

/// Each sphere of a fiber falls upon the top of a spherical wall of its own, so that the bond carries
/// nothing.
BOOST_AUTO_TEST_CASE(a_sphere_bounces_off_a_spherical_wall_by_the_coefficient_of_restitution) {
  const double radius = 4.1e-3, speed = 0.3, rise = 0.1, gap = 1e-6;
  for (const double e : {1.0, 0.5}) {
    dem::Domain around;
    around.contacts = {.restitution = e, .friction = 0.3, .law = &hertz_on_spheres};
    const V tops[2] = {{1e-3, -2e-3, 0}, {1e-3 + 2 * R, -2e-3, 0}}, below{0, 0, -radius};
    for (const V& top : tops)
      around.walls.push_back({extensions::SphereWall{top + below, radius}, {0, 0, rise}});
    dem::Assembly assembly({moving(tops[0] + V{0, 0, R + gap}, {1, 0, 0}, {0, 0, -speed})}, around,
                           {.step = 1e-7, .account_energy = true});
    int touched = 0;
    for (int n = 0; n < 20000 && !(touched > 0 && assembly.touching() == 0); ++n) {
      assembly.march(1);
      if (assembly.touching() > 0) ++touched;
      for (const auto& c : assembly.contacts()) {
        BOOST_TEST((c.key.second == dem::facet_primitive(c.key.first.number)));
        const V out = c.point - tops[c.key.first.number] - below - assembly.time() * V{0, 0, rise};
        BOOST_TEST(norm(out) == radius, boost::test_tools::tolerance(1e-9));
        BOOST_TEST(dot(c.force, out) == norm(c.force) * radius, boost::test_tools::tolerance(1e-9));
      }
    }
    BOOST_TEST(touched > 100);
    BOOST_TEST(assembly.touching() == 0);
    const double closing = speed + rise, after = rise + e * closing;
    for (const V& v : assembly.state(0, 0).velocity) {
      BOOST_TEST(v[2] == after, boost::test_tools::tolerance(1e-3));
      BOOST_TEST(std::hypot(v[0], v[1]) < 1e-9);
    }
    const dem::EnergyBalance now = assembly.energy();
    const double work = 2 * m * (speed + after) * rise,
                 lost = m * closing * closing * (1 - e * e);  // of two spheres
    BOOST_TEST(now.wall_work == work, boost::test_tools::tolerance(2e-3));
    BOOST_TEST(std::abs(now.contact_normal - lost) < 2e-3 * m * closing * closing);
    BOOST_TEST(total(now) == m * speed * speed, boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(fibers_fall_on_a_sphere) {
  SmallPacking packing = packing_in_a_box(12, 9);
  packing.around.contacts.law = &hertz_on_spheres;
  packing.around.walls = {{extensions::SphereWall{{0.012, 0.012, -0.02}, 0.0199}}};
  dem::Assembly assembly = packing.assembly({.account_energy = true});
  std::int64_t with_wall = 0;
  const dem::EnergyBalance start = assembly.energy();
  for (int n = 0; n < 10; ++n) {
    assembly.march(300);
    for (const auto& c : assembly.contacts()) with_wall += is_facet(c.key.second);
    const dem::EnergyBalance now = assembly.energy();
    BOOST_TEST(std::abs(total(now) - total(start)) < 5e-3 * (start.kinetic + start.gravity - now.gravity));
  }
  BOOST_TEST(with_wall > 2);
}

BOOST_AUTO_TEST_CASE(loops_that_are_not_compiled_are_refused) {
  dem::Domain around;
  around.walls = {{extensions::SphereWall{{0, 0, -1}, 0.5}}};
  BOOST_CHECK_THROW(dem::Assembly({moving({}, {1, 0, 0}, {})}, around, {}), dem::InvalidInput);
  BOOST_TEST(&dem::contact_law("hertz_mindlin") == &dem::law_of({}));
  BOOST_CHECK_THROW(dem::contact_law("linear"), dem::InvalidInput);
}
