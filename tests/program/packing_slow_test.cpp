#include <boost/test/unit_test.hpp>
#include <random>

#include "tests/program/packings.hpp"

BOOST_AUTO_TEST_SUITE(packing_slow_test)

using namespace fiberchain::test;

BOOST_AUTO_TEST_CASE(killed_at_20_random_moments_it_ends_the_same) {
  const FewFibers fibers(120000), others(120000);
  BOOST_REQUIRE_EQUAL(others.go().status, 0);
  std::mt19937 random(std::random_device{}());
  std::vector<int> pauses(20);
  for (int& pause : pauses) pause = static_cast<int>(random() % 80);
  BOOST_TEST(kill_and_resume(fibers, pauses) >= 10);
  BOOST_TEST(same_end(fibers, others));
}

BOOST_AUTO_TEST_CASE(the_small_packing_runs_to_its_end) {
  const Scratch scratch;
  const Outcome outcome = run({"run", FIBERCHAIN_SOURCE_DIR "/data/scenes/packing-small.yaml", "--jobs", "1"},
                              {.directory = scratch.path});
  BOOST_TEST(outcome.status == 0, outcome.error);
  BOOST_TEST(outcome.out.find("finished") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
