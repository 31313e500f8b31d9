// The declared terms of the energy balance.
#include <boost/test/unit_test.hpp>
#include <set>

#include "dem/assembly/energy_balance.hpp"
#include "dem/record/columns.hpp"
#include "dem/run/samples.hpp"

BOOST_AUTO_TEST_SUITE(energy_terms_test)

using namespace fiberchain::dem;

namespace {

constexpr EnergyBalance balance{.kinetic = 1,
                                .bonds = 2,
                                .contacts = 4,
                                .gravity = -8,
                                .bond_damping = 16,
                                .bond_friction = 32,
                                .contact_normal = 64,
                                .contact_tangential = 128,
                                .contact_rolling = 256,
                                .scheme = 4096,
                                .breaking = 8192,
                                .yielding = 16384,
                                .fluid = -512,
                                .wall_work = 1024,
                                .inserted = 2048};

}  // namespace

BOOST_AUTO_TEST_CASE(the_total_is_stored_and_dissipated_less_supplied) {
  BOOST_TEST(total(balance) ==
             1 + 2 + 4 - 8 + 16 + 32 + 64 + 128 + 256 + 4096 + 8192 + 16384 - 512 - 1024 - 2048);
  BOOST_TEST(sum_of(balance, EnergyRole::stored) == -1);
  BOOST_TEST(sum_of(balance, EnergyRole::dissipated) == 4080 + 8192 + 16384);
  BOOST_TEST(sum_of(balance, EnergyRole::supplied) == 3072);
}

BOOST_AUTO_TEST_CASE(every_term_is_declared_once) {
  std::set<double> values;
  std::set<std::string_view> columns;
  for (const EnergyMechanism& term : energy_mechanisms)
    values.insert(balance.*term.value), columns.insert(term.column);
  BOOST_TEST(values.size() == 16u);
  BOOST_TEST(columns.size() == 16u);
}

BOOST_AUTO_TEST_CASE(columns_of_tables_are_those_of_the_dictionary) {
  const auto stands_in_dictionary = [](const EnergyMechanism& term) {
    const Column& column = find_column(term.column);
    BOOST_TEST(column.unit == "J");
    BOOST_TEST(column.meaning == term.meaning);
  };
  for (const EnergyMechanism& term : energy_mechanisms) stands_in_dictionary(term);
  stands_in_dictionary(energy_total);
  BOOST_TEST(energy_columns(false).size() == 4u);
  const NamedRow cells = energy_cells(balance, true);
  BOOST_TEST(energy_columns(true).size() == cells.size());
  for (std::size_t n = 0; n < cells.size(); ++n) BOOST_TEST(energy_columns(true)[n] == cells[n].first);
  BOOST_TEST(std::get<double>(cells.back().second) == total(balance));
}

BOOST_AUTO_TEST_SUITE_END()
