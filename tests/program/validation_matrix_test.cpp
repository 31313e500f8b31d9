#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/program/validation_matrix.hpp"

BOOST_AUTO_TEST_SUITE(validation_matrix_test)

using namespace fiberchain::test;
using nlohmann::json;

namespace {

/// Parts of over 20 seconds of processor time: validation_matrix_slow_test has the whole matrix.
constexpr const char* kDear[] = {"packing", "breaking", "capstan"};

/// Every part's name, of the line of --part in the help.
std::vector<std::string> parts() {
  const std::string help = run({"validate", "--help"}).out, option = "--part LIST";
  const auto begin = help.find(option) + option.size(), end = help.find('[', begin);
  std::istringstream words(help.substr(begin, end - begin));
  std::vector<std::string> names;
  for (std::string word; words >> word;) names.push_back(word.substr(0, word.find(',')));
  return names;
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_parts_but_the_dear_hold) {
  std::vector<std::string> names = parts();
  for (const char* dear : kDear) BOOST_REQUIRE_EQUAL(std::erase(names, dear), 1);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ",") + name;
  BOOST_TEST_MESSAGE(list);
  matrix_holds({"--part", list});
}

// What a row expects, changed by twice its tolerance, and what a paper claims: the one fails, the other flips
// the verdict.
BOOST_AUTO_TEST_CASE(a_planted_expectation_fails_and_a_planted_claim_flips_its_verdict) {
  const Scratch scratch;
  std::filesystem::copy(std::string(FIBERCHAIN_SOURCE_DIR) + "/data/published", scratch.path / "published");
  const auto plant = [&](const std::string& from, const std::string& to) {
    std::string rows = content(scratch.path / "published/static.csv");
    const auto at = rows.find(from);
    BOOST_REQUIRE(at != std::string::npos);
    scratch.file("published/static.csv", rows.replace(at, from.size(), to));
    const Outcome outcome = run({"validate", "--json", "--part", "static", "--data", scratch.path.string()});
    return std::pair{outcome.status, json::parse(outcome.out)};
  };
  const auto row = [](const json& document, const std::string& id) {
    return *std::ranges::find_if(document["rows"], [&](const json& r) { return r["id"] == id; });
  };
  const auto [flipped, claimed] = plant("> 1,\"as printed, at vanishing load\"", "> 0.6,\"as printed\"");
  BOOST_TEST(flipped == 0);
  BOOST_TEST(row(claimed, "paper-fig4-rf6-small")["verdict"] == "holds");
  const auto [status, expected] = plant("0.659722,1e-05", "0.659742,1e-05");
  BOOST_TEST(status == 1);
  BOOST_TEST(row(expected, "paper-fig4-rf6-small")["as_expected"] == "no");
}

// A published value changed in its fourth digit must be noticed.
BOOST_AUTO_TEST_CASE(a_planted_fault_fails_the_validation) {
  const Scratch scratch;
  std::filesystem::copy(std::string(FIBERCHAIN_SOURCE_DIR) + "/data/published", scratch.path / "published");
  std::string beams = content(scratch.path / "published/beams.csv");
  const auto at = beams.find("0.30172");
  BOOST_REQUIRE(at != std::string::npos);
  scratch.file("published/beams.csv", beams.replace(at, 7, "0.30182"));
  const Outcome outcome =
      run({"validate", "--json", "--part", "beams,static", "--data", scratch.path.string()});
  BOOST_TEST(outcome.status == 1);
  const json document = json::parse(outcome.out);
  std::vector<std::string> failed;
  for (const json& row : document["rows"]) {
    if (row["verdict"] == "fails") failed.push_back(row["id"]);
  }
  BOOST_TEST(failed == std::vector<std::string>{"elastica-y-1"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
