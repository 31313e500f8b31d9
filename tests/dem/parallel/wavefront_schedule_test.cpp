#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <atomic>
#include <vector>

#include "dem/parallel/partition.hpp"
#include "dem/parallel/wavefront_schedule.hpp"

BOOST_AUTO_TEST_SUITE(wavefront_schedule_test)

namespace dem = fiberchain::dem;

namespace {

/// Of each part: the later ones that it reaches.
using Reach = std::vector<std::vector<int>>;

/// Runs a wavefront and notes when each piece began and ended.
struct TimedRun {
  std::vector<std::atomic<int>> first_begun, first_ended, second_begun, firsts, seconds;

  TimedRun(dem::ThreadPool& pool, const Reach& reach)
      : first_begun(reach.size()),
        first_ended(reach.size()),
        second_begun(reach.size()),
        firsts(reach.size()),
        seconds(reach.size()) {
    std::atomic<int> clock{0};
    dem::WavefrontSchedule work(static_cast<int>(reach.size()));
    work.run(
        pool, dem::PartDependencies(reach),
        [&](int k, int) {
          first_begun[k] = ++clock;
          ++firsts[k];
          volatile double busy = 1;
          for (int n = 0; n < 200 * (k % 5); ++n) busy = busy * 1.0001;
          first_ended[k] = ++clock;
        },
        [&](int k, int) {
          second_begun[k] = ++clock;
          ++seconds[k];
        });
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_piece_runs_once_and_second_pieces_wait_for_those_that_reach_them) {
  constexpr int parts = 23;
  for (const int threads : {1, 2, 3, 7}) {
    dem::ThreadPool pool(threads);
    for (int trial = 0; trial < 200; ++trial) {
      Reach reach(parts);
      for (int k = 0; k < parts; ++k) {
        for (int later = k + 1; later < parts; ++later) {
          if (trial % 4 == 3 || (k * later + trial) % (3 * (trial % 4) + 2) == 0) reach[k].push_back(later);
        }
      }
      const TimedRun run(pool, reach);
      for (int k = 0; k < parts; ++k) {
        BOOST_TEST_REQUIRE(run.firsts[k].load() == 1);
        BOOST_TEST_REQUIRE(run.seconds[k].load() == 1);
        BOOST_TEST_REQUIRE(run.first_ended[k].load() < run.second_begun[k].load());
        for (const int later : reach[k])
          BOOST_TEST_REQUIRE(run.first_ended[k].load() < run.second_begun[later].load());
      }
    }
  }
}

/// One thread works a part's second piece right behind its first: what it has read is still at hand.
BOOST_AUTO_TEST_CASE(one_thread_goes_part_by_part) {
  dem::ThreadPool pool(1);
  const Reach reach{{}, {2, 3}, {3}, {}, {}};
  const TimedRun run(pool, reach);
  for (std::size_t k = 0; k < reach.size(); ++k)
    BOOST_TEST(run.first_begun[k].load() == static_cast<int>(3 * k + 1));
}

BOOST_AUTO_TEST_CASE(parts_that_reach_others) {
  const dem::PartDependencies reach({{2, 3}, {}, {3}, {}});
  const Reach before{{}, {}, {0}, {0, 2}};
  for (int k = 0; k < reach.count(); ++k) BOOST_TEST(reach.dependencies(k) == before[k]);
}

BOOST_AUTO_TEST_CASE(parts_hold_whole_pieces_and_every_sphere_once) {
  for (const int pieces : {1, 3, 16, 40, 3000}) {
    std::vector<std::int32_t> ends;
    for (int p = 0; p < pieces; ++p) ends.push_back((ends.empty() ? 0 : ends.back()) + 8 * (14 + p % 3));
    const dem::Partition parts = dem::cache_sized_partition(ends);
    BOOST_TEST(parts.begin(0) == 0);
    BOOST_TEST(parts.end(parts.count() - 1) == ends.back());
    for (int k = 0; k < parts.count(); ++k) {
      BOOST_TEST(std::ranges::binary_search(ends, parts.end(k)));
      BOOST_TEST(parts.begin(k) < parts.end(k));
      BOOST_TEST(parts.of(parts.begin(k)) == k);
      BOOST_TEST(parts.of(parts.end(k) - 1) == k);
    }
    const int most = std::min(pieces, std::max(16, ends.back() / 2048));
    BOOST_TEST(parts.count() <= most);
    BOOST_TEST(parts.count() >= most - 1);
  }
}

BOOST_AUTO_TEST_CASE(even_parts_differ_by_one_sphere) {
  const dem::Partition parts = dem::even_partition(1003, 7);
  BOOST_TEST(parts.count() == 7);
  for (int k = 0; k < 7; ++k) BOOST_TEST(std::abs(parts.end(k) - parts.begin(k) - 143) <= 1);
}

BOOST_AUTO_TEST_SUITE_END()
