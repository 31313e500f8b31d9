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
  BOOST_TEST(saved.size() >= 19u);
  for (const auto& [name, field] : saved) {
    dem::SavedState without = saved, longer = saved, newer = saved, text = saved;
    without.erase(name);
    BOOST_TEST(refusal(without) == about(name) + "is missing");
    newer[name].version = 7;
    BOOST_TEST(refusal(newer) == about(name) + "is of version 7; this program reads version 1");
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
