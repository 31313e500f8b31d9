// The long stress tests: 1e8 steps, 1e4 turns.
#include <boost/test/unit_test.hpp>
#include <numeric>

#include "tests/dem/energy_drift.hpp"
#include "tests/dem/tumbling.hpp"

BOOST_AUTO_TEST_SUITE(stress_slow_test)

namespace dem = fiberchain::dem;
using dem::BondForm;

BOOST_AUTO_TEST_CASE(a_hundred_million_steps_keep_energy_and_momenta) {
  const auto drift = marching::energy_drift<3>(BondForm::total, {0.4, 0.2, 0.1, 0.05}, 1e8, 0.03);
  for (const marching::EnergyDrift& d : drift) {
    for (const double mean : d.mean) BOOST_TEST_MESSAGE("energy off by " << mean);
    BOOST_TEST_MESSAGE("momentum " << d.momentum << ", angular momentum " << d.angular);
    // a constant offset: the modes' slow exchange of energy changes it by a few percent either way, nothing
    // adds up
    for (const double mean : d.mean) BOOST_TEST(std::abs(mean / d.mean[1] - 1) < 0.1);
    // round-off adds up as a random walk, 1e-16 sqrt(steps) times a number of the order of one
    BOOST_TEST(d.momentum < 2e-12);
    BOOST_TEST(d.angular < 2e-12);
    BOOST_TEST(d.momentum > 1e-15);
  }
  const auto offset = [](const marching::EnergyDrift& d) {
    return std::accumulate(d.mean.begin(), d.mean.end(), 0.0);
  };
  for (std::size_t i = 1; i < drift.size(); ++i) {
    const double order = std::log2(offset(drift[i - 1]) / offset(drift[i]));
    BOOST_TEST_MESSAGE("order " << order);
    BOOST_TEST(order > 1.9);
    BOOST_TEST(order < (i == 1 ? 2.25 : 2.1));
  }
}

// Ten thousand times the steps, a hundred times the round-off in a random walk, ten thousand times if it had
// a bias.
BOOST_AUTO_TEST_CASE(round_off_in_the_momenta_grows_as_the_square_root_of_the_steps) {
  const auto total = [](double steps) {
    double sum = 0;
    for (const auto& d : marching::energy_drift<3>(BondForm::total, {0.4, 0.3, 0.2, 0.1}, steps, 0.03)) {
      sum += d.momentum + d.angular;
    }
    return sum;
  };
  const double few = total(3e3), many = total(3e7);
  BOOST_TEST_MESSAGE("momentum and angular momentum: " << few << " after 3e3 steps, " << many
                                                       << " after 3e7");
  BOOST_TEST(many / few > 20);
  BOOST_TEST(many / few < 500);
}

BOOST_AUTO_TEST_CASE(ten_thousand_turns_change_nothing) {
  for (const BondForm form : {BondForm::total, BondForm::incremental}) {
    const double bound = form == BondForm::total ? 1e-9 : 5e-5;
    for (const auto& t : {marching::tumble<2>(form, 11000, 0.5), marching::tumble<3>(form, 11000, 0.5)}) {
      BOOST_TEST_MESSAGE(t.turns << " turns, strain off by " << t.stretch << ", angular momentum by "
                                 << t.slowing);
      BOOST_TEST(t.turns > 1e4);
      BOOST_TEST(t.stretch < bound);
      BOOST_TEST(t.slowing < 1e-11);
      BOOST_TEST(t.momentum < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
