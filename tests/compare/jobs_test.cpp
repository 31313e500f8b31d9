// Threads that loops share: every piece once, nested loops, errors.
#include "compare/study/jobs.hpp"

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <set>
#include <stdexcept>
#include <string>

BOOST_AUTO_TEST_SUITE(jobs_test)

using namespace fiberchain::compare;

namespace {

/// Waits until `condition` holds; whether it came to hold in a minute.
template <class Condition>
bool comes(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::yield();
  }
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_piece_is_done_once_in_loops_within_loops) {
  constexpr std::size_t outer = 7, middle = 11, inner = 13;
  for (const int threads : {1, 2, 5}) {
    Workers workers(threads);
    for (int round = 0; round < 20; ++round) {
      std::vector<std::atomic<int>> calls(outer * middle * inner);
      std::atomic<int> early = 0;  // Boost's own checks are for one thread at a time
      const Jobs jobs = workers;
      jobs.run(outer, [&](std::size_t i) {
        jobs.run(middle, [&](std::size_t j) {
          jobs.run(inner, [&](std::size_t k) { ++calls[(i * middle + j) * inner + k]; });
          for (std::size_t k = 0; k < inner; ++k) early += calls[(i * middle + j) * inner + k] == 1 ? 0 : 1;
        });
      });
      BOOST_TEST_REQUIRE(early == 0);
      for (const auto& count : calls) BOOST_TEST_REQUIRE(count == 1);
    }
  }
  Jobs(3).run(0, [](std::size_t) { BOOST_ERROR("there is nothing to call"); });
}

// The first piece of the outer loop waits for its own inner loop, the pieces of which wait for each other.
BOOST_AUTO_TEST_CASE(a_thread_without_a_piece_of_its_loop_does_those_of_another) {
  Workers workers(2);
  std::atomic<int> at_work = 0;
  std::atomic<bool> both = false;
  workers.run(1, [&](std::size_t) {
    workers.run(2, [&](std::size_t) {
      ++at_work;
      both = comes([&] { return at_work == 2; });
    });
  });
  BOOST_TEST(both);
}

BOOST_AUTO_TEST_CASE(no_more_threads_than_asked_for) {
  for (const int threads : {1, 3}) {
    Workers workers(threads);
    std::mutex mutex;
    std::set<std::thread::id> used;
    workers.run(50, [&](std::size_t) {
      workers.run(20, [&](std::size_t) {
        const std::lock_guard lock(mutex);
        used.insert(std::this_thread::get_id());
      });
    });
    BOOST_TEST(used.size() <= static_cast<std::size_t>(threads));
    BOOST_TEST(used.contains(std::this_thread::get_id()));
  }
}

BOOST_AUTO_TEST_CASE(one_thread_begins_the_pieces_in_order) {
  std::vector<std::size_t> order;
  Jobs(1).run(5, [&](std::size_t i) { order.push_back(i); });
  BOOST_TEST(order == (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

BOOST_AUTO_TEST_CASE(the_first_error_comes_out_and_ends_its_loop_alone) {
  for (const int threads : {1, 2, 5}) {
    Workers workers(threads);
    std::vector<std::atomic<int>> calls(100);
    std::atomic<int> others = 0, errors = 0;
    workers.run(2, [&](std::size_t n) {
      if (n == 1) {
        workers.run(40, [&](std::size_t) { ++others; });
        return;
      }
      const auto piece = [&](std::size_t i) {
        ++calls[i];
        if (i == 37) throw std::runtime_error("37");
      };
      try {
        workers.run(calls.size(), piece);
      } catch (const std::runtime_error& error) {
        errors += error.what() == std::string("37") ? 1 : 0;
      }
    });
    BOOST_TEST(errors == 1);
    for (std::size_t i = 0; i <= 37; ++i) BOOST_TEST(calls[i] == 1);
    if (threads == 1) BOOST_TEST(calls[38] == 0);
    BOOST_TEST(others == 40);
  }
}

BOOST_AUTO_TEST_CASE(the_dearest_come_first_and_equal_ones_in_order) {
  BOOST_TEST(dearest_first({1, 3, 2, 3}) == (std::vector<std::size_t>{1, 3, 2, 0}));
}

BOOST_AUTO_TEST_SUITE_END()
