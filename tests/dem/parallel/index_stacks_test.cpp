#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <thread>
#include <vector>

#include "dem/parallel/index_stacks.hpp"

BOOST_AUTO_TEST_SUITE(index_stacks_test)

namespace dem = fiberchain::dem;

BOOST_AUTO_TEST_CASE(the_last_pushed_is_popped_first_from_each_stack) {
  dem::IndexStacks stacks(2, 5);
  BOOST_TEST(stacks.pop(0) == -1);
  for (const int i : {3, 0, 4}) stacks.push(0, i);
  for (const int i : {1, 2}) stacks.push(1, i);
  for (const int i : {4, 0, 3, -1}) BOOST_TEST(stacks.pop(0) == i);
  for (const int i : {2, 1, -1}) BOOST_TEST(stacks.pop(1) == i);
}

/// An index belongs to the thread that popped it: a plain counter beside it is complete at the end, and no
/// index is lost or doubled.
BOOST_AUTO_TEST_CASE(no_index_is_lost_or_doubled_when_threads_exchange_them) {
  constexpr int threads = 4, indices = 6, rounds = 50000;
  dem::IndexStacks stacks(threads, indices);
  for (int i = 0; i < indices; ++i) stacks.push(i % threads, i);
  std::vector<long> owned(indices, 0), popped(threads, 0);
  {
    std::vector<std::jthread> pool;
    for (int t = 0; t < threads; ++t) {
      pool.emplace_back([&, t] {
        for (int n = 0; n < rounds; ++n) {
          const int index = stacks.pop((t + n) % threads);
          if (index < 0) continue;
          ++owned[index], ++popped[t];
          stacks.push((t + 2 * n) % threads, index);
        }
      });
    }
  }
  long owners = 0, pops = 0;
  for (const long n : owned) owners += n;
  for (const long n : popped) pops += n;
  BOOST_TEST(owners == pops);
  BOOST_TEST(pops > rounds / 10);
  std::vector<int> left;
  for (int s = 0; s < threads; ++s) {
    for (int i = stacks.pop(s); i >= 0; i = stacks.pop(s)) left.push_back(i);
  }
  std::ranges::sort(left);
  BOOST_TEST(left == std::vector<int>({0, 1, 2, 3, 4, 5}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
