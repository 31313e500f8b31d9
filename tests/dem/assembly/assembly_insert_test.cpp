// Fibers added to a run.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/motion/time_step.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(assembly_insert_test)

using namespace scenes;

namespace {

dem::FiberGroup moved(dem::FiberGroup group, const V& by) {
  for (auto& fiber : group.fibers) move(fiber, by);
  return group;
}

double farthest(const dem::Assembly& a, int group, const dem::Assembly& b, int other) {
  double off = 0;
  for (int f = 0; f < a.fibers(group); ++f) {
    const auto x = a.state(group, f), y = b.state(other, f);
    for (std::size_t i = 0; i < x.poses.size(); ++i) {
      off = std::max(
          {off, norm(x.poses[i].position - y.poses[i].position), 1e-3 * norm(x.velocity[i] - y.velocity[i])});
    }
  }
  return off;
}

dem::Domain weightless() {
  dem::Domain around;
  around.contacts = {0.4, 0.5, 0.02};
  return around;
}

}  // namespace

/// Far from what is there, they move as they would have from a start of their own, and the others as if
/// nothing were.
BOOST_AUTO_TEST_CASE(what_is_inserted_goes_its_own_way_and_the_others_theirs) {
  dem::Fiber fiber = odd_fiber(6);
  fiber.bond_damping = 0.2;
  dem::Fiber other = odd_fiber(9, 1.2);
  other.bond_damping = 0.4;
  other.rolling_friction = 0.5;
  const dem::FiberGroup first = scattered(dem::straight_chain<3>(fiber), 9, 0.05, 3);
  const dem::FiberGroup second = scattered(curled(other, {0.1, 0.05, -0.2}), 5, 0.05, 4);
  for (const bool fluid : {false, true}) {
    dem::Domain around = weightless();
    around.gravity = {0, 3, -9.81};
    if (fluid)
      around.fluid =
          dem::Fluid{0.4 * dem::sphere_mass(fiber) / dem::stokes_drag({1, {}}, fiber).translation, {}};
    dem::FiberGroup late = fluid ? scattered(dem::straight_chain<3>(odd_fiber(9, 1.2)), 5, 0.05, 4) : second;
    const double step = 0.5 * std::min(dem::stable_time_step(fiber), dem::stable_time_step(other));
    dem::Assembly alone({first}, around, {.step = step}),
        late_alone({moved(late, {0, 0, 40})}, around, {.step = step});
    dem::Assembly both({first}, around, {.step = step, .account_energy = true});
    alone.march(423);
    both.march(223);
    const double before = total(both.energy());
    both.insert(moved(late, {0, 0, 40}));
    BOOST_TEST(both.groups() == 2);
    BOOST_TEST(both.fibers(1) == 5);
    BOOST_TEST(both.spheres() == 9 * 7 + 5 * 10);
    BOOST_TEST(both.first_sphere(1, 2) == 9 * 7 + 20);
    BOOST_TEST(total(both.energy()) == before, boost::test_tools::tolerance(1e-12));
    both.march(200);
    late_alone.march(200);
    BOOST_TEST(farthest(both, 0, alone, 0) < 1e-13);
    BOOST_TEST(farthest(both, 1, late_alone, 0) < 1e-12);
    BOOST_TEST(norm(both.state(1, 0).poses[0].position - late.fibers[0].poses[0].position - V{0, 0, 40}) >
               1e-3);
  }
}

/// A packing that is being filled: old contacts keep what they remember, new ones are found, a pause changes
/// no bit.
BOOST_AUTO_TEST_CASE(a_packing_goes_on_while_it_is_filled) {
  const SmallPacking packing = packing_in_a_box(16, 9);
  dem::Assembly assembly({packing.groups[0]}, packing.around, {.step = 6e-6, .account_energy = true});
  dem::Assembly without({packing.groups[0]}, packing.around, {.step = 6e-6, .account_energy = true});
  assembly.march(1500);
  without.march(1500);
  const std::int64_t touching = assembly.touching();
  BOOST_TEST(touching > 10);
  assembly.insert(moved(packing.groups[1], {0, 0, 0.02}));
  BOOST_TEST(assembly.touching() == touching);
  assembly.march(20);
  without.march(20);
  BOOST_TEST(farthest(assembly, 0, without, 0) < 1e-12);
  const auto old_contacts = without.contacts(), contacts = assembly.contacts();
  BOOST_TEST(old_contacts.size() == contacts.size());
  for (std::size_t i = 0; i < std::min(contacts.size(), old_contacts.size()); ++i) {
    BOOST_TEST(norm(contacts[i].force - old_contacts[i].force) < 1e-9 * (1e-6 + norm(contacts[i].force)));
  }
  assembly.march(1500);
  const std::int64_t second = assembly.first_sphere(1, 0);
  int between = 0;
  for (const auto& c : assembly.contacts())
    between += is_sphere(c.key.second) && c.key.first.number < second && c.key.second.number >= second;
  BOOST_TEST(between > 0);
  const dem::SavedState pause = assembly.saved();
  dem::Assembly again({packing.groups[0]}, packing.around, {.step = 6e-6, .account_energy = true});
  BOOST_CHECK_THROW(again.restore(pause), dem::InvalidInput);  // it has no second group yet
  again.insert(moved(packing.groups[1], {0, 0, 0.02}));
  again.restore(pause);
  assembly.march(200);
  again.march(200);
  BOOST_TEST((numbers(assembly) == numbers(again)));
  BOOST_TEST((assembly.saved() == again.saved()));
  // with all given at the start the balance is the same kind of number
  BOOST_TEST(assembly.energy().inserted > 0);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_inserted_is_refused_and_changes_nothing) {
  const dem::FiberGroup first = scattered(dem::straight_chain<3>(odd_fiber(4)), 3, 0.05, 3);
  dem::Assembly assembly({first}, weightless(), {}), same({first}, weightless(), {});
  dem::Fiber stiff = odd_fiber(4);
  stiff.material = dem::isotropic_material(3.7e9, 0.17, 431);
  BOOST_CHECK_THROW(assembly.insert(scattered(dem::straight_chain<3>(stiff), 2, 0.05, 3)), dem::InvalidInput);
  BOOST_CHECK_THROW(assembly.insert({first.chain, {}}), dem::InvalidInput);
  dem::FiberGroup short_of_spheres = first;
  short_of_spheres.fibers[0].poses.pop_back();
  BOOST_CHECK_THROW(assembly.insert(short_of_spheres), dem::InvalidInput);
  assembly.march(50);
  same.march(50);
  BOOST_TEST((numbers(assembly) == numbers(same)));
  BOOST_TEST(assembly.groups() == 1);
}

BOOST_AUTO_TEST_CASE(a_flow_that_varies_across_periodic_sides_is_refused) {
  const dem::FiberGroup group = scattered(dem::straight_chain<3>(odd_fiber(7)), 5, 0.01, 7);
  dem::Domain around;
  around.fluid = dem::Fluid{1e-3, {dem::simple_shear(3)}};  // u_x = 3 y
  around.period = {2, 0, 2};
  BOOST_CHECK_NO_THROW(dem::Assembly({group}, around, {}));
  around.period = {0, 2, 0};
  BOOST_CHECK_THROW(dem::Assembly({group}, around, {}), dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(spheres_beyond_a_wall_and_unstable_steps_are_refused) {
  const dem::FiberGroup group = scattered(dem::straight_chain<3>(odd_fiber(7)), 5, 0.01, 7);
  dem::Domain around;
  around.walls = {{dem::Plane{{0, 0, 3}, {0, 0, 1}}}};
  BOOST_CHECK_THROW(dem::Assembly({group}, around, {}), dem::InvalidInput);
  BOOST_CHECK_THROW(dem::Assembly({group}, {}, {.step = 1.5 * dem::stable_time_step(group.chain.fiber)}),
                    dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
