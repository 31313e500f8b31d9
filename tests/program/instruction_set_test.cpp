#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "dem/simd/instruction_set.hpp"
#include "tests/program/packings.hpp"

BOOST_AUTO_TEST_SUITE(instruction_set_test)

using namespace fiberchain::test;
namespace dem = fiberchain::dem;

// The inner loops of another instruction set round otherwise: a run that goes on keeps to its own.
BOOST_AUTO_TEST_CASE(a_run_goes_on_with_the_instruction_set_it_began_with) {
  const FewFibers whole(4000), stopped(4000);
  BOOST_TEST(whole.go({"--instruction-set", "scalar"}).status == 0);
  Started run(stopped.arguments({"--instruction-set", "scalar"}), stopped.here());
  wait_until([&] { return std::filesystem::exists(stopped.out("s.checkpoint.previous")); });
  run.send(SIGTERM);
  run.finish();
  const Outcome resumed = stopped.go({"--resume"});
  BOOST_TEST(resumed.status == 0, resumed.error);
  BOOST_TEST(resumed.error.find(", with scalar as before") != std::string::npos, resumed.error);
  BOOST_TEST(same_end(whole, stopped));
}

BOOST_AUTO_TEST_CASE(another_instruction_set_for_a_run_that_goes_on_is_refused) {
  const FewFibers fibers(200);
  BOOST_TEST(fibers.go({"--instruction-set", "scalar"}).status == 0);
  const std::string before = content(fibers.out("s.checkpoint"));
  const std::string widest(dem::name(dem::best_instruction_set()));
  BOOST_TEST_REQUIRE(widest != "scalar");
  const Outcome outcome = fibers.go({"--resume", "--instruction-set", widest});
  BOOST_TEST(outcome.status != 0);
  BOOST_TEST(outcome.error.find("was written by another program") != std::string::npos, outcome.error);
  BOOST_TEST(content(fibers.out("s.checkpoint")) == before);
}

BOOST_AUTO_TEST_CASE(an_instruction_set_is_one_of_those_there_are) {
  const FewFibers fibers(200);
  for (const char* wrong : {"avx", "", "scalar,avx2", "sse2", "AVX2"}) {
    const Outcome outcome = fibers.go({"--instruction-set", wrong});
    BOOST_TEST(outcome.status == 2, wrong);
    BOOST_TEST(is_one_error(outcome.error), outcome.error);
    BOOST_TEST(outcome.error.find("--instruction-set") != std::string::npos, outcome.error);
  }
  BOOST_TEST(!std::filesystem::exists(fibers.path / "out"));
}

// Whoever read the messages has gone: the run has not.
BOOST_AUTO_TEST_CASE(messages_that_nobody_reads_do_not_end_a_run) {
  const FewFibers fibers(200);
  Circumstances unread = fibers.here();
  unread.nobody_reads_errors = true;
  BOOST_TEST(run(fibers.arguments(), unread).status == 0);
  BOOST_TEST(content(fibers.out("s.csv")).find("finished") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
