#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "dem/trajectory/checkpoint.hpp"
#include "tests/program/packings.hpp"

// Keys of a scene set on the command line, one value or many.
BOOST_AUTO_TEST_SUITE(sweep_test)

using namespace fiberchain::test;
namespace io = fiberchain::dem;
namespace fs = std::filesystem;

namespace {

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

Outcome go(const Scratch& scratch, std::vector<std::string> more, const std::string& scene = "s.yaml") {
  more.insert(more.begin(), {"run", scene, "--out", "out", "--jobs", "2"});
  return run(more, {.directory = scratch.path, .environment = {{"PATH", "/nonexistent"}}});
}

/// Lines of a CSV file without its comments.
std::vector<std::string> rows_of(const fs::path& path) {
  std::vector<std::string> rows;
  std::istringstream text(content(path));
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with('#')) rows.push_back(line);
  }
  return rows;
}

const std::vector<std::string> kFour = {"--set", "contacts.friction=0.2,0.4", "--set", "filling.seed=3..4"};

}  // namespace

BOOST_AUTO_TEST_CASE(every_combination_has_a_row) {
  const FewFibers fibers(300);
  const Outcome outcome = go(fibers, kFour);
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  const auto rows = rows_of(fibers.out("s-sweep.csv"));
  BOOST_REQUIRE_EQUAL(rows.size(), 5u);
  BOOST_TEST(rows[0].starts_with("contacts.friction,filling.seed,fibers,spheres,"), rows[0]);
  BOOST_TEST(rows[0].ends_with(",status,directory"), rows[0]);
  const char* begins[] = {"0.2,3,31,217,", "0.2,4,31,217,", "0.4,3,31,217,", "0.4,4,31,217,"};
  for (int n = 0; n < 4; ++n) {
    BOOST_TEST(rows[n + 1].starts_with(begins[n]), rows[n + 1]);
    BOOST_TEST(holds(rows[n + 1], ",finished,"), rows[n + 1]);
  }
  // one of them by itself, from a text that says so
  std::string text = short_fibers(300, few);
  text.replace(text.find("friction: 0.3"), 13, "friction: 0.4");
  fibers.file("alone.yaml", text);
  BOOST_REQUIRE_EQUAL(go(fibers, {}, "alone.yaml").status, 0);
  const auto state = [&](const std::string& name) {
    return io::read_checkpoint(fibers.path / "out" / name).state;
  };
  BOOST_TEST((state("contacts.friction=0.4,filling.seed=3/s.checkpoint") == state("alone.checkpoint")));
}

BOOST_AUTO_TEST_CASE(a_sweep_goes_on) {
  const FewFibers fibers(300);
  BOOST_REQUIRE_EQUAL(go(fibers, kFour).status, 0);
  const auto before = rows_of(fibers.out("s-sweep.csv"));
  BOOST_TEST(go(fibers, kFour).status == 3);  // every run is there already
  std::vector<std::string> more = kFour;
  more.push_back("--resume");
  fs::remove_all(fibers.path / "out/contacts.friction=0.2,filling.seed=4");
  const Outcome outcome = go(fibers, more);
  BOOST_TEST(outcome.status == 0, outcome.error);
  const auto after = rows_of(fibers.out("s-sweep.csv"));
  BOOST_REQUIRE_EQUAL(after.size(), before.size());
  for (std::size_t n = 0; n < after.size(); ++n)
    BOOST_TEST(after[n].substr(0, after[n].find(",finished")).substr(0, 40) ==
               before[n].substr(0, before[n].find(",finished")).substr(0, 40));
}

BOOST_AUTO_TEST_CASE(one_that_fails_keeps_its_row) {
  const FewFibers fibers(3000);
  const Outcome outcome = go(fibers, {"--set", "filling.velocity=[0, 0, -1],[0, 0, -999]", "--json"});
  BOOST_TEST(outcome.status == 3);
  const auto rows = nlohmann::json::parse(outcome.out)["rows"];
  BOOST_REQUIRE_EQUAL(rows.size(), 2u);
  BOOST_TEST(rows[0]["filling.velocity"] == "[0, 0, -1]");
  BOOST_TEST(rows[0]["status"] == "finished");
  BOOST_TEST(holds(rows[1]["status"], "likely cause"), rows[1]["status"]);
  const auto lines = rows_of(fibers.out("s-sweep.csv"));
  BOOST_REQUIRE_EQUAL(lines.size(), 3u);
  BOOST_TEST(lines[2].starts_with("\"[0, 0, -999]\","), lines[2]);
  BOOST_TEST(holds(lines[2], "likely cause"), lines[2]);
}

BOOST_AUTO_TEST_CASE(one_value_is_one_run) {
  const FewFibers fibers(200);
  const Outcome outcome = go(fibers, {"--set", "contacts.friction=0.45", "--set", "fibers[0].count=20"});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  const std::string table = content(fibers.out("s.csv"));
  BOOST_TEST(holds(table, "# set: contacts.friction=0.45; fibers[0].count=20\n"), table);
  const io::Checkpoint end = io::read_checkpoint(fibers.out("s.checkpoint"));
  BOOST_TEST(holds(end.keys, "contacts.friction = 0.45\n"));
  const Outcome plain = go(fibers, {"--resume"});
  BOOST_TEST(plain.status == 2);
  BOOST_TEST(holds(plain.error, "contacts.friction: 0.3, was 0.45"), plain.error);
}

BOOST_AUTO_TEST_CASE(other_kinds_are_swept_too) {
  const Scratch scratch;
  scratch.file("c.yaml", content(fs::path(FIBERCHAIN_SOURCE_DIR) / "data/scenes/cantilever.yaml"));
  const Outcome outcome = go(scratch, {"--set", "load.reduced=1..3"}, "c.yaml");
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  BOOST_TEST(rows_of(scratch.path / "out/c-sweep.csv").size() == 4u);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_set_is_refused_before_the_first_run) {
  const std::pair<std::vector<std::string>, const char*> faults[] = {
      {{"--set", "contacts.frictoin=0.2,0.3"}, "unknown key 'contacts.frictoin'; did you mean 'friction'?"},
      {{"--set", "contacts.friction=0.2,-1"},
       "contacts.friction: '-1' is out of range; allowed: a number at least 0"},
      {{"--set", "contacts.friction"}, "is no KEY=VALUE"},
      {{"--set", "contacts.friction="}, "has an empty value"},
      {{"--set", "contacts.friction=0.2,,1"}, "has an empty value"},
      {{"--set", "gravity=[0,0"}, "does not close"},
      {{"--set", "filling.seed=3..1"}, "runs backward"},
      {{"--set", "filling.seed=1..20000"}, "makes more than 10000 runs"},
      {{"--set", "filling.seed=1", "--set", "filling.seed=2"}, "a second time"},
      {{"--set", "motion.integrator=rk4"}, "allowed: leapfrog, leapfrog-stiff"},
      {{"--set", "scene=flow"}, "the kind of the scene stays"},
  };
  const FewFibers fibers(200);
  for (const auto& [words, says] : faults) {
    const Outcome outcome = go(fibers, words);
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(is_one_error(outcome.error), outcome.error);
    BOOST_TEST(holds(outcome.error, "error: --set"), outcome.error);
    BOOST_TEST(holds(outcome.error, says), outcome.error);
    BOOST_TEST(!fs::exists(fibers.path / "out"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
