// Cases dealt to shards, and their tables merged.
#include "compare/study/shard.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "compare/study/errors.hpp"
#include "compare/study/merge.hpp"
#include "tests/compare/messages.hpp"

BOOST_AUTO_TEST_SUITE(shards_test)

using namespace fiberchain::compare;
namespace fs = std::filesystem;

namespace {

/// Directories of shards as a study would write them.
struct Parts {
  Parts() : path(fs::temp_directory_path() / fmt::format("fiberchain-shards-{}", ::getpid())) {
    fs::remove_all(path);
  }
  ~Parts() { fs::remove_all(path); }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void write(const std::string& directory, const std::string& file, const std::string& text) const {
    fs::create_directories(path / directory);
    std::ofstream(path / directory / file) << text;
  }
  std::vector<fs::path> all(const std::vector<std::string>& names) const {
    std::vector<fs::path> paths;
    for (const std::string& name : names) paths.push_back(path / name);
    return paths;
  }

  fs::path path;
};

std::string header(const std::string& shard, const std::string& commit = "abc",
                   const std::string& more = "") {
  return "# program: fiberchain\n# commit: " + commit + "\n# command: /opt/" + shard.substr(0, 1) +
         "/fiberchain tables x --load 1,2 --shard " + shard.substr(0, 3) + " --out 'a b' --jobs " +
         shard.substr(0, 1) + more + "\n# shard: " + shard + "\n# cpu: of " + shard.substr(0, 1) + "\n";
}

/// Three cases, the second with two rows, in two shards.
void write_two(const Parts& parts) {
  parts.write(
      "a", "x.csv",
      header("1/2 of 3 cases") + "case,load,status\n1,0.1,finished\n3,0.30000000000000004,\"a, b\"\n");
  parts.write("a", "fixed.csv", header("1/2 of 3 cases") + "time\n7\n");
  parts.write("b", "x.csv", header("2/2 of 3 cases") + "case,load,status\n2,2e-1,first\n2,nan,second\n");
}

std::string refusal(const Parts& parts, const std::vector<std::string>& names) {
  return message_of<InputError>([&] { merge_shards(parts.all(names)); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_case_falls_to_one_shard) {
  const std::vector<double> costs{3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 0.5, 0.5};
  for (const int count : {1, 2, 3, 4, 7, 16}) {
    std::vector<int> owners(costs.size()), owners_by_cost(costs.size());
    double most = 0;
    for (int index = 1; index <= count; ++index) {
      for (const std::size_t n : dealt({index, count}, costs.size())) ++owners[n];
      double load = 0;
      for (const std::size_t n : dealt_by_cost({index, count}, costs)) ++owners_by_cost[n], load += costs[n];
      most = std::max(most, load);
    }
    BOOST_TEST(owners == std::vector<int>(costs.size(), 1), boost::test_tools::per_element());
    BOOST_TEST(owners_by_cost == std::vector<int>(costs.size(), 1), boost::test_tools::per_element());
    // dearest first to the least loaded is within 4/3 of the best (Graham 1969)
    const double best = std::max(9.0, std::accumulate(costs.begin(), costs.end(), 0.0) / count);
    BOOST_TEST(most <= 4.0 / 3.0 * best);
  }
}

BOOST_AUTO_TEST_CASE(a_part_is_written_i_of_n) {
  BOOST_TEST((parse_shard("--shard", "2/4") == Shard{2, 4}));
  for (const char* text : {"", "2", "0/4", "5/4", "2/4/8", "a/b", "2/", "-1/4", "1/1000000", "1.5/4"}) {
    const std::string message = message_of<InputError>([&] { parse_shard("--shard", text); });
    BOOST_TEST(message.find(fmt::format("--shard: '{}'", text)) == 0u, message);
  }
}

BOOST_AUTO_TEST_CASE(rows_come_as_the_whole_has_them) {
  const Parts parts;
  write_two(parts);
  const Merged merged = merge_shards(parts.all({"b", "a"}));
  BOOST_TEST(merged.cases == 3u);
  BOOST_REQUIRE_EQUAL(merged.tables.size(), 2u);
  BOOST_TEST(merged.tables[0].file == "fixed.csv");
  const std::string text = to_csv(merged.tables[1].table);
  BOOST_TEST(
      text.ends_with("load,status\n0.1,finished\n2e-1,first\nnan,second\n0.30000000000000004,\"a, b\"\n"),
      text);
  // provenance: what is the same once, what differs of each
  for (const char* line :
       {"# commit: abc\n", "# merged_shards: 2\n", "# shard 1/2 cpu: of 1\n", "# shard 2/2 cpu: of 2\n",
        "# shard 2/2 command: /opt/2/fiberchain tables x --load 1,2 --shard 2/2 --out 'a b' --jobs 2\n"})
    BOOST_TEST(text.find(line) != std::string::npos, text);
  BOOST_TEST(text.find("1/2 commit") == std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(parts_that_do_not_belong_together_are_refused) {
  const Parts parts;
  write_two(parts);
  const auto has = [](const std::string& message, std::initializer_list<const char*> words) {
    for (const char* word : words)
      BOOST_TEST(message.find(word) != std::string::npos, message << ": " << word);
  };
  has(refusal(parts, {"a"}), {"shards are missing: 2/2"});
  has(refusal(parts, {"a", "b", "a"}), {"shard 1/2 comes twice"});
  has(refusal(parts, {"a", "c"}), {"no such directory"});
  parts.write("other", "x.csv", header("2/2 of 3 cases", "def") + "case,load,status\n2,1,f\n");
  has(refusal(parts, {"a", "other"}), {"commit", "'abc'", "'def'"});
  parts.write("asked", "x.csv",
              header("2/2 of 3 cases", "abc", " --peaks 1..2") + "case,load,status\n2,1,f\n");
  has(refusal(parts, {"a", "asked"}), {"command", "--peaks 1..2"});
  parts.write("of_four", "x.csv", header("2/4 of 3 cases") + "case,load,status\n2,1,f\n");
  has(refusal(parts, {"a", "of_four"}), {"2/4", "not of one whole"});
  parts.write("stopped", "x.csv", header("2/2 of 3 cases") + "case,load,status\n");
  has(refusal(parts, {"a", "stopped"}), {"case 2 of 3 is in no part"});
  parts.write("doubled", "x.csv", header("2/2 of 3 cases") + "case,load,status\n2,1,f\n3,1,f\n");
  has(refusal(parts, {"a", "doubled"}), {"case 3 is in"});
  parts.write("beyond", "x.csv", header("2/2 of 3 cases") + "case,load,status\n4,1,f\n");
  has(refusal(parts, {"a", "beyond"}), {"case '4' is none of 1..3"});
  parts.write("whole", "x.csv", "# commit: abc\nload\n1\n");
  has(refusal(parts, {"a", "whole"}), {"is of no shard"});
  parts.write("b", "fixed.csv", header("2/2 of 3 cases") + "time\n7\n");
  has(refusal(parts, {"a", "b"}), {"fixed.csv has no column case"});
}

BOOST_AUTO_TEST_SUITE_END()
