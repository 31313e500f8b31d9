// The saved state of an assembly by its fields.
#include <boost/test/unit_test.hpp>

#include "dem/model/errors.hpp"
#include "tests/dem/small_packing.hpp"

BOOST_AUTO_TEST_SUITE(assembly_restore_test)

using namespace scenes;

namespace {

dem::AssemblyOptions accounted() { return {.step = 6e-6, .account_energy = true}; }

/// A packing with contacts between fibers and with walls.
dem::SavedState contacts_saved() {
  dem::Assembly assembly = packing_in_a_box(12, 9).assembly(accounted());
  assembly.march(1500);
  BOOST_TEST_REQUIRE(assembly.touching() > 5);
  return assembly.saved();
}

/// Message of the refusal by an assembly of the same fibers.
std::string refusal(const dem::SavedState& saved) {
  dem::Assembly assembly = packing_in_a_box(12, 9).assembly(accounted());
  try {
    assembly.restore(saved);
  } catch (const dem::InvalidInput& error) {
    return error.what();
  }
  return "none";
}

std::string about(const std::string& name) { return "field '" + name + "' of the saved state "; }

}  // namespace

BOOST_AUTO_TEST_CASE(a_restored_state_is_the_saved_one) {
  const dem::SavedState saved = contacts_saved();
  dem::Assembly again = packing_in_a_box(12, 9).assembly(accounted());
  BOOST_TEST((again.saved() != saved));
  again.restore(saved);
  BOOST_TEST((again.saved() == saved));
}

BOOST_AUTO_TEST_CASE(a_bad_field_is_named) {
  const dem::SavedState saved = contacts_saved();
  BOOST_TEST(refusal(saved) == "none");
  BOOST_TEST(saved.size() >= 21u);
  for (const auto& [name, field] : saved) {
    dem::SavedState without = saved, longer = saved, newer = saved, text = saved;
    without.erase(name);
    BOOST_TEST(refusal(without) == about(name) + "is missing");
    newer[name].version = 7;
    BOOST_TEST(refusal(newer) ==
               about(name) + "is of version 7; this program reads version " +
                   (name == "bond_dissipation" || name == "contact_accumulators" ? "2" : "1"));
    std::visit([](auto& numbers) { numbers.push_back(0); }, longer[name].values);
    BOOST_TEST(refusal(longer).starts_with(about(name) + "has "), name);
    const bool integers = field.values.index() == 1;
    if (integers)
      text[name].values = std::vector<double>{1};
    else
      text[name].values = std::vector<std::int64_t>{1};
    BOOST_TEST(refusal(text) ==
               about(name) + (integers ? "holds reals, not integers" : "holds integers, not reals"));
  }
  dem::SavedState more = saved;
  more["charge"] = {1, std::vector<double>{1}};
  BOOST_TEST(refusal(more) == about("charge") + "is unknown");
}

/// As if the run had not been interrupted: the deepest overlap of the first part is not forgotten.
BOOST_AUTO_TEST_CASE(largest_overlap_and_path_are_those_of_the_whole_run) {
  dem::Assembly whole = packing_in_a_box(12, 9).assembly(accounted());
  whole.march(1500);
  const double overlap = whole.deepest_overlap(), path = whole.longest_path();
  BOOST_TEST_REQUIRE(overlap > 0);
  dem::Assembly resumed = packing_in_a_box(12, 9).assembly(accounted());
  resumed.restore(whole.saved());
  BOOST_TEST(resumed.deepest_overlap() == overlap);
  BOOST_TEST(resumed.longest_path() == path);
  whole.march(300);
  resumed.march(300);
  BOOST_TEST(resumed.deepest_overlap() == whole.deepest_overlap());
  BOOST_TEST(resumed.longest_path() == whole.longest_path());
  BOOST_TEST(whole.deepest_overlap() >= overlap);
  // an assembly of stand-ins that lie in each other takes the saved run's, not its own
  SmallPacking stacked = packing_in_a_box(12, 9);
  for (auto& group : stacked.groups) {
    const auto first = group.fibers.front();
    for (std::size_t f = 1; f < group.fibers.size(); ++f) {
      group.fibers[f] = first;
      move(group.fibers[f], {1e-4 * static_cast<double>(f), 0, 0});
    }
  }
  dem::AssemblyOptions anywhere = accounted();
  anywhere.placed_anywhere = true;
  dem::Assembly stand_in = stacked.assembly(anywhere);
  BOOST_TEST(stand_in.deepest_overlap() > overlap);
  stand_in.restore(resumed.saved());
  BOOST_TEST(stand_in.deepest_overlap() == resumed.deepest_overlap());
}

BOOST_AUTO_TEST_CASE(inserted_fibers_leave_the_largest_overlap_as_it_was) {
  const SmallPacking packing = packing_in_a_box(12, 9);
  dem::Assembly assembly({packing.groups[0]}, packing.around, accounted());
  assembly.march(1500);
  const double overlap = assembly.deepest_overlap();
  BOOST_TEST_REQUIRE(overlap > 0);
  dem::FiberGroup late = packing.groups[1];
  for (auto& fiber : late.fibers)
    for (auto& pose : fiber.poses) pose.position[2] += 0.5;
  assembly.insert(late);
  BOOST_TEST(assembly.deepest_overlap() == overlap);
}

BOOST_AUTO_TEST_CASE(contacts_of_other_spheres_are_refused) {
  const dem::SavedState saved = contacts_saved();
  for (const std::int64_t number : {std::int64_t{-6}, std::int64_t{1} << 40}) {
    dem::SavedState wrong = saved;
    std::get<std::vector<std::int64_t>>(wrong["contact_keys"].values)[1] = number;
    BOOST_TEST(refusal(wrong).starts_with(about("contact_keys") + "names a pair"), number);
  }
  dem::SavedState swapped = saved;
  auto& pairs = std::get<std::vector<std::int64_t>>(swapped["contact_keys"].values);
  std::swap_ranges(pairs.begin(), pairs.begin() + 3, pairs.end() - 3);
  BOOST_TEST(refusal(swapped) ==
             about("contact_keys") + "names pairs that are not neighbors, or in another order");
}

BOOST_AUTO_TEST_SUITE_END()
