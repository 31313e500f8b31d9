#include <boost/test/unit_test.hpp>
#include <sstream>

#include "tests/program/packings.hpp"

// Tables and sweeps in parts (--shard), merged, against the whole.
BOOST_AUTO_TEST_SUITE(sharded_runs_test)

using namespace fiberchain::test;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// Lines of a CSV file without its comments.
std::vector<std::string> lines_of(const fs::path& path) {
  std::vector<std::string> lines;
  std::istringstream text(content(path));
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with('#')) lines.push_back(line);
  }
  return lines;
}

void check_goes(const Scratch& scratch, const Words& words) {
  const Outcome outcome = run(words, {.directory = scratch.path, .environment = {{"PATH", "/nonexistent"}}});
  BOOST_REQUIRE_MESSAGE(outcome.status == 0, words[0] << " " << words[1] << ": " << outcome.error);
}

/// Runs the command whole into "whole", in `count` shards into "parts", and merges these.
void in_shards(const Scratch& scratch, const Words& command, int count) {
  const auto with = [&](const Words& more) {
    Words words = command;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  check_goes(scratch, with({"--out", "whole"}));
  Words merge = {"merge"};
  for (int index = count; index >= 1; --index) {
    const std::string n = std::to_string(index), of = std::to_string(count);
    check_goes(scratch, with({"--out", "parts", "--shard", n + "/" + of, "--jobs", "1"}));
    merge.push_back("parts/shard-" + n + "-of-" + of);
  }
  merge.insert(merge.end(), {"--out", "parts"});
  check_goes(scratch, merge);
}

void check_same(const Scratch& scratch, const std::string& file, std::size_t rows) {
  const auto whole = lines_of(scratch.path / "whole" / file),
             merged = lines_of(scratch.path / "parts" / file);
  BOOST_TEST(whole.size() == rows + 1);
  BOOST_TEST(merged == whole, boost::test_tools::per_element());
}

}  // namespace

// Number by number: the text of the numbers is compared.
BOOST_AUTO_TEST_CASE(damping_in_four_shards_is_the_whole) {
  const Scratch scratch;
  in_shards(scratch,
            {"tables", "damping", "--aspect-ratio", "5..7", "--bond-damping", "2,5", "--form",
             "total,incremental", "--peaks", "0..2", "--poisson-ratio", "0.17"},
            4);
  check_same(scratch, "damping.csv", 12);
}

BOOST_AUTO_TEST_CASE(tables_of_several_rows_a_case_are_the_whole) {
  const Scratch scratch;
  in_shards(scratch,
            {"tables", "friction", "--aspect-ratio", "5", "--rolling-friction", "0,1,3", "--peaks", "1..2"},
            2);
  check_same(scratch, "friction.csv", 3);
  const auto peaks = lines_of(scratch.path / "whole/friction-peaks.csv");
  BOOST_TEST(peaks.size() > 6u);
  check_same(scratch, "friction-peaks.csv", peaks.size() - 1);
}

BOOST_AUTO_TEST_CASE(stability_shards_are_the_whole) {
  const Scratch scratch;
  in_shards(scratch,
            {"stability", "--aspect-ratio", "5", "--poisson-ratio", "0.2", "--bond-damping", "0,0.5",
             "--bond", "paper", "--step", "10"},
            3);
  check_same(scratch, "stability.csv", 4);
  check_same(scratch, "stability-growth.csv", 2);
}

BOOST_AUTO_TEST_CASE(parts_of_a_study_are_dealt_whole) {
  const Scratch scratch;
  in_shards(scratch,
            {"tables", "materials", "--part", "two-modes,wires", "--aspect-ratio", "7", "--diameters", "3"},
            2);
  for (const char* file : {"materials.csv", "materials-wires.csv"}) {
    const auto rows = lines_of(scratch.path / "whole" / file).size() - 1;
    BOOST_TEST(rows > 1u);
    check_same(scratch, file, rows);
  }
}

BOOST_AUTO_TEST_CASE(the_matrix_in_shards_is_the_whole) {
  const Scratch scratch;
  in_shards(scratch, {"validate", "--part", "beams"}, 3);
  const auto rows = lines_of(scratch.path / "whole/validation.csv").size() - 1;
  BOOST_TEST(rows > 5u);
  check_same(scratch, "validation.csv", rows);
}

BOOST_AUTO_TEST_CASE(a_sweep_of_packings_in_shards) {
  const FewFibers fibers(300);
  const auto go = [&](Words more) {
    more.insert(more.begin(), {"run", "s.yaml", "--out", "out", "--jobs", "1", "--set",
                               "contacts.friction=0.2,0.4", "--set", "filling.seed=3,4"});
    return run(more, {.directory = fibers.path, .environment = {{"PATH", "/nonexistent"}}});
  };
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const Outcome outcome = go({"--shard", shard});
    BOOST_REQUIRE_MESSAGE(outcome.status == 0, outcome.error);
  }
  BOOST_TEST(go({"--shard", "5/5"}).error.find("no case is left for 5/5") != std::string::npos);
  const Outcome merged =
      run({"merge", "out/shard-1-of-3", "out/shard-2-of-3", "out/shard-3-of-3", "--out", "out"},
          {.directory = fibers.path});
  BOOST_REQUIRE_MESSAGE(merged.status == 0, merged.error);
  const auto rows = lines_of(fibers.out("s-sweep.csv"));
  BOOST_REQUIRE_EQUAL(rows.size(), 5u);
  BOOST_TEST(rows[0].starts_with("contacts.friction,filling.seed,fibers,"), rows[0]);
  const char* begins[] = {"0.2,3,", "0.2,4,", "0.4,3,", "0.4,4,"};
  for (int n = 0; n < 4; ++n) {
    BOOST_TEST(rows[n + 1].starts_with(begins[n]), rows[n + 1]);
    const std::string directory = rows[n + 1].substr(rows[n + 1].find("\"contacts"));
    BOOST_TEST(fs::exists(fibers.path / "out" / directory.substr(1, directory.size() - 2) / "s.checkpoint"),
               directory);
  }
  const Outcome single = run({"run", "s.yaml", "--shard", "1/2"}, {.directory = fibers.path});
  BOOST_TEST(single.status == 2);
  BOOST_TEST(single.error.find("--shard") != std::string::npos, single.error);
}

BOOST_AUTO_TEST_SUITE_END()
