#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <sstream>
#include <thread>

#include "dem/record/csv.hpp"
#include "dem/run/filling_watch.hpp"
#include "tests/program/packings.hpp"

// Fibers that are too many, that take long to go in, or that find no room.
BOOST_AUTO_TEST_SUITE(insertion_test)

using namespace fiberchain::test;
namespace io = fiberchain::dem;
namespace fs = std::filesystem;

namespace {

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string many(const std::string& aspect_ratio, const std::string& count) {
  return with(with(short_fibers(10, few), "aspect_ratio: 6", "aspect_ratio: " + aspect_ratio), "count: 31",
              "count: " + count);
}

Outcome run_in(const Scratch& scratch, const std::string& text, Circumstances circumstances = {}) {
  scratch.file("s.yaml", text);
  circumstances.directory = scratch.path;
  return run({"run", "s.yaml", "--out", "out", "--jobs", "1"}, circumstances);
}

/// Three batches into a region that only one fills: the second finds no room at step 1000 or so.
struct Crowded : FewFibers {
  explicit Crowded(const std::string& no_room)
      : FewFibers(3000, ", attempts: 300, batches: {number: 3, interval: 5 ms, no_room: " + no_room + "}",
                  {240, "50 mm"}) {}
};

io::Table row_of(const Crowded& run) { return io::read_csv(run.out("s.csv")).table; }

}  // namespace

BOOST_AUTO_TEST_CASE(more_spheres_than_numbers_are_refused_by_file_and_line) {
  const Scratch scratch;
  const Outcome outcome = run_in(scratch, many("1000000", "10000000"));
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(is_one_error(outcome.error), outcome.error);
  BOOST_TEST(
      holds(outcome.error, "s.yaml:2: fibers: are 10000010000000 spheres; allowed: at most 2000000000"),
      outcome.error);
}

BOOST_AUTO_TEST_CASE(what_does_not_go_into_memory_is_refused_before_it_is_filled) {
  const Scratch scratch;
  for (const char* command : {"run", "check"}) {
    scratch.file("s.yaml", many("50", "1000000"));
    const Outcome outcome =
        run({command, "s.yaml"}, {.directory = scratch.path, .address_space = 2'000'000'000});
    const bool runs = std::string(command) == "run";
    BOOST_TEST(outcome.status == (runs ? 2 : 0), outcome.error);
    BOOST_TEST(holds(outcome.error, runs ? "51000000 spheres need " : "warning: the scene needs "),
               outcome.error);
    BOOST_TEST(!fs::exists(scratch.path / "results"));
    if (runs)
      BOOST_TEST(holds(outcome.error, "available (limit of the process's address space)"), outcome.error);
  }
}

BOOST_AUTO_TEST_CASE(a_filling_can_be_stopped) {
  const Scratch scratch;
  scratch.file("s.yaml", short_fibers(10, {800, "50 mm"}, ", attempts: 1000000000"));
  Started program({"run", "s.yaml", "--out", "out"}, {.directory = scratch.path});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  program.send(SIGINT);
  const Outcome outcome = program.finish();
  BOOST_TEST(outcome.status == 130);
  BOOST_TEST(holds(outcome.error, "stopped while filling: "), outcome.error);
  BOOST_TEST(holds(outcome.error, " of 800 fibers placed"), outcome.error);
  BOOST_TEST(!fs::exists(scratch.path / "out"));
}

BOOST_AUTO_TEST_CASE(a_filling_shows_how_far_it_is) {
  std::ostringstream terminal;
  const io::InsertionWatch watch =
      io::filling_watch([] { return false; }, [](const std::string&) {}, terminal, true);
  watch({3, 7, 64});
  std::this_thread::sleep_for(std::chrono::milliseconds(350));
  watch({4, 7, 128});
  BOOST_TEST(terminal.str().starts_with("\rfilling: 4 of 7 fibers placed, attempt 128 for the next"));
  BOOST_TEST(terminal.str().size() <= 80);
}

BOOST_AUTO_TEST_CASE(a_batch_without_room_ends_the_run_with_its_files) {
  const Crowded run("end");
  const Outcome outcome = run.go();
  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(holds(outcome.error, "error: batch 2 of 3 at t = 0.00"), outcome.error);
  BOOST_TEST(holds(outcome.error, "of 80 found no place in 300 attempts"), outcome.error);
  const io::Table row = row_of(run);
  BOOST_TEST(row.number(0, "fibers") == 80);
  BOOST_TEST(holds(row.text(0, "status"), "batch 2 of 3"));
  BOOST_TEST(io::TrajectoryReader(run.out("s.h5")).frames() > 1);
  const std::string log = log_of(run.out("s-log.csv"));
  const Outcome again = run.go({"--resume"});
  BOOST_TEST(again.status == 3, again.error);
  BOOST_TEST(holds(again.error, "error: batch 2 of 3 at t = 0.00"), again.error);
  BOOST_TEST(log_of(run.out("s-log.csv")) == log);
}

BOOST_AUTO_TEST_CASE(a_batch_without_room_may_wait_or_come_with_fewer) {
  for (const char* how : {"wait", "fewer"}) {
    const Crowded run(how), stopped(how);
    const Outcome outcome = run.go();
    BOOST_TEST(outcome.status == 0, outcome.error);
    const io::Table row = row_of(run);
    BOOST_TEST(row.number(0, "fibers") < 240);
    BOOST_TEST(row.number(0, "fibers") >= 80);
    BOOST_TEST(row.number(0, "spheres") == 7 * row.number(0, "fibers"));
    BOOST_TEST(row.text(0, "status").starts_with("finished"));
    const io::TrajectoryReader trajectory(run.out("s.h5"));
    const io::TrajectoryFrame last = trajectory.read(trajectory.frames() - 1);
    BOOST_TEST(static_cast<double>(last.position.size()) == row.number(0, "spheres"));
    for (const io::FrameBond& bond : last.bonds) {
      const auto first = static_cast<std::size_t>(bond.first);
      BOOST_REQUIRE(first + 1 < last.fiber.size());
      BOOST_TEST(last.fiber[first] == last.fiber[first + 1]);
    }
    BOOST_TEST(kill_and_resume(stopped, {3, 15}) >= 1);
    BOOST_TEST(same_end(run, stopped));
  }
}

BOOST_AUTO_TEST_SUITE_END()
