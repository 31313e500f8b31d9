// Threads share a loop: every call is made once, and a thread that has no work left takes others'.
#include <atomic>
#include <boost/test/unit_test.hpp>
#include <thread>
#include <vector>

#include "dem/parallel/thread_pool.hpp"

BOOST_AUTO_TEST_SUITE(thread_pool_test)

namespace dem = fiberchain::dem;

BOOST_AUTO_TEST_CASE(every_call_is_made_once_by_one_of_the_threads) {
  for (const int threads : {1, 2, 3, 7}) {
    dem::ThreadPool pool(threads);
    BOOST_TEST(pool.threads() == threads);
    for (const int count : {0, 1, 2, 5, 113}) {  // also fewer calls than threads, and none
      for (int round = 0; round < 50; ++round) {
        std::vector<std::atomic<int>> calls(count);
        std::atomic<int> strangers{0};
        pool.parallel_for(count, [&](int i, int thread) {
          ++calls[i];
          if (thread < 0 || thread >= threads) ++strangers;
        });
        BOOST_TEST(strangers == 0);
        for (const auto& n : calls) BOOST_TEST_REQUIRE(n == 1);
      }
    }
  }
}

/// The first call waits until all others are made: also those of its own thread's share, which only another
/// thread can take then. Without work stealing this would never end.
BOOST_AUTO_TEST_CASE(calls_of_a_busy_thread_are_taken_by_another) {
  constexpr int count = 41;
  for (const int threads : {2, 3, 5}) {
    dem::ThreadPool pool(threads);
    for (int round = 0; round < 20; ++round) {
      std::atomic<int> made{0};
      pool.parallel_for(count, [&](int i, int) {
        if (i == 0) {
          while (made < count - 1) std::this_thread::yield();
        } else {
          ++made;
        }
      });
      BOOST_TEST(made == count - 1);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
