// Fibers at rest on walls and on themselves, through the whole engine: beam theory, troughs, settling in a
// fluid, curls.
#include <boost/test/unit_test.hpp>

#include "reference/supported_beam.hpp"
#include "tests/dem/assembly/assembly_scenes.hpp"
#include "tests/dem/transverse_fibers.hpp"

BOOST_AUTO_TEST_SUITE(resting_fiber_test)

using namespace transverse;

namespace {

constexpr double g = 9.81;

void within(double value, double expected, double tolerance, const std::string& what) {
  BOOST_TEST(std::abs(value - expected) <= tolerance, what << ": " << value << ", expected " << expected);
}

/// A still fluid that stops what moves within about `time` [s].
dem::Fluid still(const dem::Fiber& fiber, double time) {
  return {dem::sphere_mass(fiber) / time / dem::stokes_drag({1, {}}, fiber).translation, {}};
}

}  // namespace

/// Across a trough of two planes a fiber rests on its ends and sags under its weight. The chain's bond bends
/// in its middle only: as Timoshenko's beam whose shear flexibility is 1 / K_t - l^3 / (12 E I) a bond,
/// exactly.
BOOST_AUTO_TEST_CASE(a_fiber_across_a_trough_sags_as_a_beam_on_two_supports) {
  double worst = 0;
  for (const auto model : {dem::BondModel::paper, dem::BondModel::corrected}) {
    for (const int bonds : {4, 11}) {
      for (const auto form : {dem::BondForm::incremental, dem::BondForm::total}) {
        dem::Fiber fiber = fiber_of(2.6e6, 0.31, 1130, 1.66e-3);
        fiber.aspect_ratio = bonds;
        fiber.bond_model = model;
        const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
        const double R = dem::sphere_radius(fiber), m = dem::sphere_mass(fiber), l = dem::bond_length(fiber),
                     L = bonds * l;
        const double slope = 0.35, weak = 0.1 / bonds;  // weak gravity keeps the sag small
        dem::Domain around;
        around.gravity = tilted(-g * weak, 0, 0);
        // normals lean toward the middle; x is up, y along the fiber
        for (const double side : {-1.0, 1.0}) {
          const V normal = tilted(std::cos(slope), -side * std::sin(slope), 0);
          around.walls.push_back({dem::Plane{tilted(0, side * L / 2, 0) - R * normal, normal}});
        }
        around.fluid = still(fiber, 0.4 * bonds * bonds * dem::bond_time_step(fiber));
        dem::Assembly assembly({{chain, {dem::placed(chain, {tilted(0, -L / 2, 0), tilted(0, 1, 0)})}}},
                               around, {.form = form});
        assembly.march(4000 + 120 * bonds * bonds);
        const auto contacts = assembly.contacts();
        BOOST_REQUIRE(contacts.size() == 2u);
        for (const auto& c : contacts) {
          BOOST_TEST(
              (c.key.first == dem::sphere_primitive(0) || c.key.first == dem::sphere_primitive(bonds)));
          within(untilted(c.force)[0] / (0.5 * (bonds + 1) * m * g * weak), 1, 1e-6, "half the weight");
        }
        const double EI = dem::bending_stiffness(fiber),
                     flexibility = l / dem::shear_stiffness(fiber) - l * l * l / (12 * EI);
        const double shear =
            flexibility > 1e-9 * l / dem::shear_stiffness(fiber) ? l / flexibility : infinite;
        const auto beam = ref::beam_on_supports({bonds + 1, l, m * g * weak, EI, shear, 0, bonds});
        const auto state = assembly.state(0, 0);
        const double low = untilted(state.poses[0].position)[0];
        double largest = 0;
        for (int i = 0; i <= bonds; ++i) largest = std::max(largest, beam.deflection[i]);
        BOOST_TEST(largest / L < 2e-4);
        BOOST_TEST(largest / L > 1e-7);
        for (int i = 1; i < bonds; ++i) {
          const double off = (low - untilted(state.poses[i].position)[0]) / beam.deflection[i] - 1;
          within(off, 0, 2e-4, "sag of " + std::to_string(i) + " of " + std::to_string(bonds));
          worst = std::max(worst, std::abs(off));
        }
        // the bending moment in the middle of each bond
        const auto bond_states = assembly.bonds(0, 0);
        for (int i = 0; form == dem::BondForm::incremental && i < bonds; ++i) {
          double moment = beam.left * (i + 0.5) * l;
          for (int j = 0; j <= i; ++j) moment -= m * g * weak * (i + 0.5 - j) * l;
          within(bond_states[i].bending_angle / (moment / dem::bond_stiffness(fiber).bend), 1, 1e-3, "angle");
        }
      }
    }
  }
  BOOST_TEST_MESSAGE("sag off by at most " << worst);
}

BOOST_AUTO_TEST_CASE(a_trough_carries_by_the_lever_of_its_sides) {
  const dem::Fiber fiber = fiber_of(2.6e6, 0.31, 1130, 1.66e-3);
  const double left = 0.4, right = 1.1, W = dem::sphere_mass(fiber) * g, R = dem::sphere_radius(fiber);
  dem::Domain around;
  around.gravity = tilted(-g, 0, 0);
  around.contacts = {0.3, 0};
  const V a = tilted(std::cos(left), std::sin(left), 0), b = tilted(std::cos(right), -std::sin(right), 0);
  around.walls = {{dem::Plane{{}, a}}, {dem::Plane{{}, b}}};
  // touches both: x a = R, x b = R
  const double c = std::cos(left + right), along = R / (1 + c);
  const V at = untilted(along * (a + b));
  dem::Assembly assembly({group_of(fiber, at[0], at[1], {})}, around, {});
  assembly.march(30000);
  const auto contacts = assembly.contacts();
  BOOST_REQUIRE(contacts.size() == 4u);
  for (const auto& contact : contacts) {
    const double expected = contact.key.second == dem::facet_primitive(0)
                                ? W * std::sin(right) / std::sin(left + right)
                                : W * std::sin(left) / std::sin(left + right);
    within(norm(contact.force) / expected, 1, 1e-6, "side");
    const V& normal = contact.key.second == dem::facet_primitive(0) ? a : b;
    within(dot(contact.force, normal) / expected, 1, 1e-6, "normal");
  }
}

BOOST_AUTO_TEST_CASE(a_fiber_settles_through_a_still_fluid_onto_the_floor) {
  dem::Fiber fiber = fiber_of(2.6e6, 0.31, 1130, 1.66e-3);
  fiber.aspect_ratio = 3;
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  dem::Domain around;
  around.gravity = tilted(-g, 0, 0);
  around.fluid = still(fiber, 2.3e-3);
  around.contacts = {0.4, 0.5};
  around.walls = {{dem::Plane{{}, tilted(1, 0, 0)}}};
  dem::Assembly assembly({{chain, {dem::placed(chain, {tilted(3e-3, 0, 0), tilted(0, 1, 0.4)})}}}, around,
                         {});
  const double m = dem::sphere_mass(fiber),
               terminal = m * g / dem::stokes_drag(*around.fluid, fiber).translation;
  assembly.march(static_cast<int>(0.03 / assembly.step()));
  BOOST_TEST(assembly.touching() == 0);
  within(motion_of(assembly, 0, 2).velocity[0] / -terminal, 1, 1e-5, "terminal speed");
  assembly.march(static_cast<int>(0.2 / assembly.step()));
  BOOST_TEST(assembly.touching() == 4);
  double carried = 0;
  for (const auto& contact : assembly.contacts()) carried += untilted(contact.force)[0];
  within(carried / (4 * m * g), 1, 1e-8, "carried");
  within(norm(assembly.state(0, 0).velocity[1]) / terminal, 0, 1e-9, "at rest");
}

namespace {

/// A helix of more than a turn of `bonds` bonds, its turns `pitch` diameters apart.
dem::Chain<3> helix(int bonds, double pitch) {
  const double around = 0.45, up = pitch / (2 * 3.14159265358979 / around);  // a bond
  dem::Fiber fiber = fiber_of(2.6e6, 0.31, 1130, 1.66e-3);
  fiber.aspect_ratio = bonds;
  fiber.bond_damping = 0.3;
  return scenes::curled(fiber, {around * up, 0, around});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_curled_fiber_touches_itself_where_its_turns_meet_and_nowhere_else) {
  for (const double pitch : {2.2, 0.9}) {
    const dem::Chain<3> chain = helix(25, pitch);
    dem::ChainState<3> start = dem::placed(chain, tilt, tilted(1e-3, 2e-3, 3e-3), {});
    int close = 0;
    for (int i = 0; i <= 25; ++i) {
      for (int j = i + 2; j <= 25; ++j) {
        const double distance = norm(start.poses[i].position - start.poses[j].position);
        if (distance < chain.fiber.diameter) ++close;
      }
    }
    for (const auto form : {dem::BondForm::incremental, dem::BondForm::total}) {
      dem::Domain around;
      around.contacts = {0.5, 0.3};
      dem::Assembly assembly({{chain, {start}}}, around, {.form = form});
      BOOST_TEST(assembly.touching() == close);
      for (const auto& c : assembly.contacts()) BOOST_TEST(c.key.second.number - c.key.first.number > 1);
      if (pitch > 2) {
        // apart: it rests in its shape
        BOOST_TEST(close == 0);
        assembly.march(5000);
        const auto now = assembly.state(0, 0);
        for (int i = 0; i <= 25; ++i) {
          BOOST_TEST(norm(now.poses[i].position - start.poses[i].position) < 1e-11 * chain.fiber.diameter);
        }
        continue;
      }
      // its turns overlap at rest: they press each other apart until bonds and contacts balance
      BOOST_TEST(close > 5);
      V sum{};
      for (const auto& c : assembly.contacts()) sum = sum + c.force;
      assembly.march(30000);
      const auto now = assembly.state(0, 0);
      BOOST_TEST(assembly.touching() > 2);
      const double apart_before = norm(start.poses[14].position - start.poses[0].position);
      const double apart_now = norm(now.poses[14].position - now.poses[0].position);
      BOOST_TEST(apart_now > apart_before + 1e-3 * chain.fiber.diameter);
      V momentum{};
      double fastest = 0;
      for (const V& v : now.velocity) momentum = momentum + v, fastest = std::max(fastest, norm(v));
      BOOST_TEST(norm(momentum) < 1e-10);
      BOOST_TEST_MESSAGE("curl of pitch " << pitch << " d: " << close << " contacts, then "
                                          << assembly.touching() << ", still moves at " << fastest << " m/s");
      for (const auto& c : assembly.contacts()) {
        BOOST_TEST(c.key.second.number - c.key.first.number > 1);
        const double overlap = chain.fiber.diameter - norm(now.poses[c.key.first.number].position -
                                                           now.poses[c.key.second.number].position);
        BOOST_TEST(c.overlap == overlap, boost::test_tools::tolerance(1e-6));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
