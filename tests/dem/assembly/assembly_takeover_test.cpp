// Fibers that go on from the saved state of another assembly.
#include <boost/test/unit_test.hpp>

#include "dem/model/errors.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(assembly_takeover_test)

using namespace scenes;

namespace {

constexpr double kStep = 6e-6;
constexpr std::int64_t kBefore = 1500;

const SmallPacking& box() {
  static const SmallPacking packing = packing_in_a_box(12, 9);
  return packing;
}

const dem::SavedState& pressed() {
  static const dem::SavedState saved = [] {
    dem::Assembly assembly = box().assembly({.step = kStep});
    assembly.march(kBefore);
    BOOST_TEST_REQUIRE(assembly.touching() > 5);
    return assembly.saved();
  }();
  return saved;
}

/// The assembly that goes on from there with these options in this domain.
dem::Assembly gone_on(dem::AssemblyOptions options, const dem::Domain& around, dem::CarriedLosses& losses,
                      const dem::SavedState& saved = pressed()) {
  const dem::CarriedState state = dem::carried_state(saved);
  std::vector<dem::FiberGroup> groups;
  for (std::size_t g = 0; g < state.groups.size(); ++g)
    groups.push_back({box().groups[g].chain, state.groups[g].fibers});
  options.steps_before = std::llround(state.time / *options.step);
  options.time_shift = state.time - static_cast<double>(options.steps_before) * *options.step;
  dem::Assembly assembly(std::move(groups), around, std::move(options));
  losses = assembly.take_over(state);
  return assembly;
}

double largest_difference(const dem::Assembly& a, const dem::Assembly& b) {
  double largest = 0, size = 0;
  for (int g = 0; g < a.groups(); ++g) {
    for (int f = 0; f < a.fibers(g); ++f) {
      const dem::ChainState<3> s = a.state(g, f), t = b.state(g, f);
      for (std::size_t i = 0; i < s.poses.size(); ++i) {
        largest = std::max(largest, dem::norm(s.velocity[i] - t.velocity[i]));
        size = std::max(size, dem::norm(s.velocity[i]));
      }
    }
  }
  return largest / size;
}

dem::Assembly uninterrupted(std::int64_t more) {
  dem::Assembly assembly = box().assembly({.step = kStep});
  assembly.march(kBefore + more);
  return assembly;
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_changed_goes_on_alike) {
  dem::CarriedLosses losses;
  dem::Assembly assembly = gone_on({.step = kStep}, box().around, losses);
  BOOST_TEST(losses.contacts > 5);
  BOOST_TEST(losses.kept == losses.contacts);
  BOOST_TEST(losses.bonds_without == 0);
  BOOST_TEST(assembly.time() == static_cast<double>(kBefore) * kStep);
  BOOST_TEST(largest_difference(uninterrupted(0), assembly) < 1e-12);
  assembly.march(500);
  BOOST_TEST(largest_difference(uninterrupted(500), assembly) < 1e-7);
}

// Without its histories the same start is far off: what the test before holds is no matter of course.
BOOST_AUTO_TEST_CASE(histories_matter) {
  dem::SavedState saved = pressed();
  for (double& number : std::get<std::vector<double>>(saved["contact_history"].values)) number *= 0.9;
  dem::CarriedLosses losses;
  dem::Assembly assembly = gone_on({.step = kStep}, box().around, losses, saved);
  assembly.march(500);
  BOOST_TEST(largest_difference(uninterrupted(500), assembly) > 1e-6);
  saved = pressed();
  for (double& number : std::get<std::vector<double>>(saved["bond_history"].values)) number *= 0.99;
  dem::Assembly softer = gone_on({.step = kStep}, box().around, losses, saved);
  softer.march(500);
  BOOST_TEST(largest_difference(uninterrupted(500), softer) > 1e-4);
}

// Velocities stand half a step back: a finer step begins where the coarse one was, to second order of both.
BOOST_AUTO_TEST_CASE(another_step_begins_at_the_same_velocities) {
  dem::CarriedLosses losses;
  dem::Assembly finer = gone_on({.step = kStep / 3}, box().around, losses);
  const dem::Assembly whole = uninterrupted(0);
  BOOST_TEST(finer.time() == whole.time(), boost::test_tools::tolerance(1e-15));
  BOOST_TEST(largest_difference(whole, finer) < 2e-5);  // dashpots at a velocity half a step earlier
  BOOST_TEST(finer.energy().kinetic == whole.energy().kinetic, boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(walls_go_by_what_spheres_overlap) {
  dem::CarriedLosses losses, without;
  dem::Domain around = box().around;
  std::rotate(around.walls.begin(), around.walls.begin() + 2, around.walls.end());
  dem::Assembly assembly = gone_on({.step = kStep}, around, losses);
  BOOST_TEST(losses.kept == losses.contacts);
  assembly.march(300);
  BOOST_TEST(largest_difference(uninterrupted(300), assembly) < 1e-7);
  std::int64_t at_walls = 0;
  for (const dem::ContactState& contact : uninterrupted(0).contacts())
    at_walls += !dem::is_sphere(contact.key.second);
  BOOST_TEST_REQUIRE(at_walls > 0);
  around.walls.clear();
  gone_on({.step = kStep}, around, without);
  BOOST_TEST(without.contacts - without.kept == at_walls);
}

BOOST_AUTO_TEST_CASE(another_form_finds_its_strains_in_the_poses) {
  dem::Assembly total = box().assembly({.step = kStep, .form = dem::BondForm::total});
  total.march(kBefore);
  dem::CarriedLosses losses;
  const dem::Assembly assembly = gone_on({.step = kStep}, box().around, losses, total.saved());
  BOOST_TEST(losses.bonds_without == 12 * 8 + 9 * 13);
  BOOST_TEST(assembly.energy().bonds == total.energy().bonds, boost::test_tools::tolerance(3e-6));
}

BOOST_AUTO_TEST_CASE(any_instruction_set_reads_the_same) {
  const dem::CarriedState wide = dem::carried_state(pressed());
  dem::Assembly narrow = box().assembly({.step = kStep, .instruction_set = dem::InstructionSet::scalar});
  narrow.march(kBefore);
  const dem::CarriedState other = dem::carried_state(narrow.saved());
  BOOST_REQUIRE_EQUAL(wide.groups.size(), other.groups.size());
  for (std::size_t g = 0; g < wide.groups.size(); ++g) {
    BOOST_REQUIRE_EQUAL(wide.groups[g].histories.size(), other.groups[g].histories.size());
    double largest = 0, size = 0;
    for (std::size_t n = 0; n < wide.groups[g].histories.size(); ++n) {
      largest = std::max(largest, std::abs(wide.groups[g].histories[n] - other.groups[g].histories[n]));
      size = std::max(size, std::abs(wide.groups[g].histories[n]));
    }
    BOOST_TEST(largest < 1e-6 * size);
    BOOST_TEST(size > 0);
  }
}

BOOST_AUTO_TEST_CASE(axes_along_an_arc_are_its_tangents) {
  dem::Fiber fiber{dem::isotropic_material(2.6e6, 0.17, 1300), 1.37e-3, 13};
  const dem::Chain<3> arc = curled(fiber, {0, 0, 0.07});
  dem::ChainState<3> state =
      dem::placed(arc, dem::normalized(dem::Quaternion<double>{0.3, {0.5, -0.2, 0.9}}), {0.1, 0.2, -0.3}, {});
  const dem::ChainState<3> exact = state;
  for (auto& pose : state.poses) pose.orientation = {1, {0, 0, 0}};
  dem::orient_along(state);
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    const V e{1, 0, 0};
    BOOST_TEST(dem::norm(dem::rotate(state.poses[i].orientation, e) -
                         dem::rotate(exact.poses[i].orientation, e)) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_refused) {
  dem::SavedState saved = pressed();
  saved.erase("bond_history");
  BOOST_CHECK_THROW(dem::carried_state(saved), dem::InvalidInput);
  for (const char* name : {"group_layout", "fiber_order", "contact_keys"}) {
    for (const std::int64_t number : {std::int64_t{-7}, std::int64_t{1} << 40}) {
      saved = pressed();
      std::get<std::vector<std::int64_t>>(saved[name].values)[0] = number;
      BOOST_CHECK_THROW(dem::carried_state(saved), dem::InvalidInput);
    }
  }
  dem::Assembly fewer = packing_in_a_box(11, 9).assembly({.step = kStep});
  BOOST_CHECK_THROW(fewer.take_over(dem::carried_state(pressed())), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
