// Solutions share no state: threads side by side get, bit for bit, what one thread gets alone.
#include <array>
#include <boost/test/unit_test.hpp>
#include <thread>
#include <vector>

#include "reference/chain_modes.hpp"
#include "reference/damped_elastica.hpp"
#include "reference/elastica.hpp"
#include "reference/reissner.hpp"

BOOST_AUTO_TEST_SUITE(threads_test)

namespace ref = fiberchain::reference;

namespace {

std::vector<double> solve_all(int offset) {
  std::vector<double> results;
  for (int i = 0; i < 20; ++i) {
    const double load = 0.1 + 0.37 * ((i + offset) % 20);
    results.push_back(ref::elastica_shooting(load).y);
    results.push_back(ref::elastica_closed_form(load).x);
    results.push_back(ref::reissner_tip(load, 300, 40).angle);
    const auto chain = ref::with_bond_damping(ref::linear_chain({5 + i, 1, 1, 0.3, 1}), load);
    results.push_back(ref::first_bending_mode(chain).damping);
  }
  const ref::Release release{ref::Release::Shape::static_load, 1.0 + offset};
  results.push_back(ref::damped_elastica(ref::chain_layout(8, 2), release, {3.0}, {6}).samples[0].y);
  return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(threads_do_not_disturb_each_other) {
  std::array<std::vector<double>, 4> alone;
  std::array<std::vector<double>, 4> together;
  for (int i = 0; i < 4; ++i) alone[i] = solve_all(i);
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back([&, i] { together[i] = solve_all(i); });
  }
  for (int i = 0; i < 4; ++i) BOOST_TEST(alone[i] == together[i]);
  BOOST_TEST((alone[0] != alone[1]));
}

BOOST_AUTO_TEST_SUITE_END()
