// A whole small packing: no contact is missed, and neither threads, a pause, nor a wider vector change what
// happens.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(packing_contact_test)

using namespace scenes;

namespace {

/// Pairs that touch, by the positions alone: every sphere with every other, and with every wall.
std::set<dem::ContactKey> brute_force(const dem::Assembly& assembly, const dem::Domain& around) {
  const dem::PlacedSpheres spheres = assembly.placed();
  std::vector<std::int64_t> fiber;
  for (int g = 0, number = 0; g < assembly.groups(); ++g) {
    for (int f = 0; f < assembly.fibers(g); ++f, ++number)
      fiber.insert(fiber.end(), assembly.chain(g).poses.size(), number);
  }
  std::set<dem::ContactKey> pairs;
  for (std::size_t i = 0; i < spheres.radius.size(); ++i) {
    for (std::size_t j = i + 1; j < spheres.radius.size(); ++j) {
      if (j == i + 1 && fiber[i] == fiber[j]) continue;
      V r = spheres.position[j] - spheres.position[i];
      for (int c = 0; c < 3; ++c) {
        if (around.period[c] > 0) r[c] -= around.period[c] * std::round(r[c] / around.period[c]);
      }
      if (norm(r) < spheres.radius[i] + spheres.radius[j])
        pairs.insert({dem::sphere_primitive(static_cast<std::int64_t>(i)),
                      dem::sphere_primitive(static_cast<std::int64_t>(j))});
    }
    for (std::size_t w = 0; w < around.walls.size(); ++w) {
      const dem::Wall& wall = around.walls[w];
      if (dem::is_active(wall, assembly.time()) &&
          dem::gap_to(wall, spheres.position[i], assembly.time()) < spheres.radius[i]) {
        pairs.insert({dem::sphere_primitive(static_cast<std::int64_t>(i)),
                      dem::facet_primitive(static_cast<std::int64_t>(w))});
      }
    }
  }
  return pairs;
}

void no_contact_is_missed(const SmallPacking& packing, int moments, int steps) {
  dem::Assembly assembly = packing.assembly({});
  std::size_t most = 0, all = 0, with_walls = 0, between = 0;
  std::int64_t second_group = assembly.first_sphere(1, 0);
  for (int n = 0; n < moments; ++n) {
    assembly.march(steps);
    const auto exact = brute_force(assembly, packing.around);
    std::set<dem::ContactKey> found;
    for (const dem::ContactState& c : assembly.contacts()) {
      found.insert(c.key);
      with_walls += is_facet(c.key.second);
      between +=
          is_sphere(c.key.second) && c.key.first.number < second_group && c.key.second.number >= second_group;
    }
    BOOST_TEST(found.size() == assembly.contacts().size());
    BOOST_TEST(static_cast<std::size_t>(assembly.touching()) == exact.size());
    BOOST_TEST((found == exact),
               "moment " << n << ": " << found.size() << " found, " << exact.size() << " by brute force");
    most = std::max(most, exact.size());
    all += exact.size();
  }
  BOOST_TEST_MESSAGE(assembly.spheres()
                     << " spheres: up to " << most << " contacts at once, " << all << " compared, "
                     << with_walls << " with walls, " << between << " between the kinds");
  BOOST_TEST(most > 150u);
  BOOST_TEST(between > 100u);
  BOOST_TEST(with_walls > 100u);
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_contact_is_missed_in_a_box) {
  no_contact_is_missed(packing_in_a_box(60, 40), 24, 160);
}

BOOST_AUTO_TEST_CASE(no_contact_is_missed_across_periodic_sides) {
  no_contact_is_missed(packing_in_a_periodic_box(60, 40), 20, 170);
}

/// GroupSnapshot at after every step, while fast fibers pass through the cells.
BOOST_AUTO_TEST_CASE(no_contact_of_fast_fibers_is_missed) {
  SmallPacking packing = packing_in_a_periodic_box(40, 25);
  for (auto& group : packing.groups) {
    for (std::size_t f = 0; f < group.fibers.size(); ++f) {
      const double turn = 2.399963 * static_cast<double>(f);  // every one another way
      const V fast{6 * std::cos(turn), 6 * std::sin(turn), -2 - 4 * std::cos(3 * turn)};
      for (V& v : group.fibers[f].velocity) v = fast;
    }
  }
  no_contact_is_missed(packing, 90, 7);
}

BOOST_AUTO_TEST_CASE(threads_and_a_pause_change_no_bit) {
  struct Way {
    SmallPacking packing;
    dem::Rolling rolling;
    int threads;
  };
  for (auto& [packing, rolling, threads] :
       {Way{packing_in_a_box(20, 15), dem::Rolling::set_valued, 3},
        Way{packing_in_a_periodic_box(20, 15), dem::Rolling::explicit_sign, 2}}) {
    SmallPacking rubbing = packing;
    for (auto& group : rubbing.groups) group.chain.fiber.rolling_friction = 0.7;
    const auto fresh = [&, how = rolling](int with) {
      return rubbing.assembly({.rolling = how, .threads = with, .account_energy = true});
    };
    dem::Assembly one = fresh(1), more = fresh(threads);
    one.march(20);
    more.march(20);
    BOOST_TEST((numbers(more) == numbers(one)), threads << " threads");
    one.march(740);
    const dem::SavedState pause = one.saved();
    one.march(40);
    BOOST_TEST(one.touching() > 20);
    more.restore(pause);
    BOOST_TEST(more.steps() == 760);
    more.march(40);
    BOOST_TEST((numbers(more) == numbers(one)), threads << " threads");
    BOOST_TEST((more.saved() == one.saved()), threads << " threads");
    dem::Assembly third = fresh(1);
    third.restore(pause);
    for (int n = 0; n < 8; ++n) third.march(5);
    BOOST_TEST((third.saved() == one.saved()));
  }
}

BOOST_AUTO_TEST_CASE(a_pause_in_a_fluid_changes_no_bit) {
  SmallPacking packing = packing_in_a_box(12, 9);
  packing.stir_with_fluid();
  for (const auto form : {dem::BondForm::incremental, dem::BondForm::total}) {
    dem::Assembly one = packing.assembly({.form = form}), two = packing.assembly({.form = form});
    one.march(700);
    two.march(333);
    const auto pause = two.saved();
    dem::Assembly third = packing.assembly({.form = form}),
                  threaded = packing.assembly({.form = form, .threads = 2});
    third.restore(pause);
    threaded.restore(pause);
    third.march(25);
    threaded.march(25);
    BOOST_TEST((numbers(threaded) == numbers(third)));
    third.march(342);
    BOOST_TEST(one.touching() > 5);
    BOOST_TEST((numbers(one) == numbers(third)));
  }
}

/// Round-off grows in collisions: compared while few have happened.
BOOST_AUTO_TEST_CASE(instruction_sets_agree_to_round_off) {
  for (SmallPacking packing : {packing_in_a_box(25, 15), packing_in_a_periodic_box(25, 15)}) {
    for (const bool fluid : {false, true}) {
      if (fluid) packing.stir_with_fluid();
      std::vector<double> first;
      std::int64_t touching = 0;
      for (const auto set : dem::available_instruction_sets()) {
        dem::Assembly assembly = packing.assembly({.instruction_set = set});
        for (int n = 0; n < 6; ++n) {
          assembly.march(50);
          touching = std::max(touching, assembly.touching());
        }
        const std::vector<double> now = numbers(assembly);
        if (first.empty()) first = now;
        double off = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
          off = std::max(off, std::abs(now[i] - first[i]) / (1 + std::abs(first[i])));
        BOOST_TEST(off < 1e-9);
      }
      BOOST_TEST(touching > 0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
