#include <algorithm>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(program_test)

using namespace fiberchain::test;
using nlohmann::json;

namespace {

const std::string kScenes = std::string(FIBERCHAIN_SOURCE_DIR) + "/data/scenes/";

using Command = std::vector<std::string>;

const Command kCommands[] = {{},
                             {"columns"},
                             {"run"},
                             {"check"},
                             {"tables"},
                             {"tables", "static"},
                             {"tables", "damping"},
                             {"tables", "friction"},
                             {"tables", "contact"},
                             {"tables", "materials"},
                             {"tables", "shear"},
                             {"tables", "packing"},
                             {"fit"},
                             {"calibrate"},
                             {"materials"},
                             {"stability"},
                             {"bench"},
                             {"validate"}};

const Command kJsonCommands[] = {
    {"columns"},
    {"check", kScenes + "packing.yaml"},
    {"check", kScenes + "release.yaml"},
    {"run", kScenes + "cantilever.yaml"},
    {"run", kScenes + "cantilever-march.yaml"},
    {"run", kScenes + "cantilever-spatial.yaml"},
    {"run", kScenes + "rod-frame.yaml"},
    {"tables", "static", "--aspect-ratio", "10,13", "--poisson-ratio", "0.17", "--load", "0.5,6"},
    {"tables", "static", "--aspect-ratio", "5", "--load", "1", "--method", "march", "--form",
     "total,incremental"},
    {"calibrate", "--damping-ratio", "0.01", "--aspect-ratio", "13", "--poisson-ratio", "0.17"},
    {"calibrate", "--material", "brass", "--diameter", "1 mm", "--aspect-ratio", "13"},
    {"materials"},
    {"tables", "damping", "--aspect-ratio", "7", "--load", "0.05"},
    {"tables", "friction", "--aspect-ratio", "5", "--load", "0.7", "--rolling-friction", "0,3", "--law",
     "set_valued,explicit_sign", "--step", "0.1", "--peaks", "0..2"},
    {"tables", "friction", "--aspect-ratio", "5", "--amplitude", "0.1", "--rolling-friction", "2"},
    {"tables", "contact", "--test", "1,2"},
    {"tables", "materials", "--part", "modes,wires", "--aspect-ratio", "7", "--modes", "2", "--diameters",
     "3"},
    {"tables", "shear", "--spheres", "2,7", "--interacting", "5", "--stresslets", "3"},
    {"tables", "shear", "--part", "stiffness,buckling"},
    {"tables", "packing", "--fibers", "500", "--seeds", "0", "--bond-damping", "0.1", "--friction", "1",
     "--stiffness", "2", "--duration", "0.005", "--samples", "20"},
    {"run", kScenes + "flow-shear.yaml"},
    {"run", kScenes + "flow-flexible.yaml"},
    {"fit", "--aspect-ratio", "5..9", "--held-out", "12"},
    {"stability", "--aspect-ratio", "4", "--poisson-ratio", "0.17", "--bond-damping", "0,0.6"},
    {"bench", "--quick", "--case", "static"},
    {"bench", "--quick", "--case", "skips,kernels"},
    {"bench", "--quick", "--case", "threads"},
    {"bench", "--quick", "--case", "sizes"},
    {"validate", "--part", "beams,press"},
};

Command with(Command command, const Command& more) {
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

/// The words of a command line; double quotes keep spaces.
Command words(const std::string& line) {
  std::istringstream stream(line);
  Command all;
  for (std::string word; stream >> std::quoted(word);) all.push_back(word);
  return all;
}

json rows(const Command& command) {
  const Outcome outcome = run(with(command, {"--json"}));
  BOOST_REQUIRE_EQUAL(outcome.status, 0);
  return json::parse(outcome.out)["rows"];
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

namespace boost::test_tools::tt_detail {
template <>
struct print_log_value<program_test::Command> {
  void operator()(std::ostream& out, const program_test::Command& command) const {
    for (const std::string& word : command) out << word << ' ';
  }
};
}  // namespace boost::test_tools::tt_detail

BOOST_AUTO_TEST_SUITE(program_test)

BOOST_AUTO_TEST_CASE(version_names_the_commit) {
  const Outcome outcome = run({"--version"});
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(outcome.error == "");
  const std::regex pattern(R"(fiberchain \d+\.\d+\.\d+ \(commit (unknown|[0-9a-f]{40}(-dirty)?)\)\n)");
  std::smatch match;
  BOOST_REQUIRE(std::regex_match(outcome.out, match, pattern));
  const json columns = json::parse(run({"columns", "--json"}).out);
  BOOST_TEST(columns["provenance"]["commit"] == match[1].str());
}

// Every command explains itself and gives examples; every example works as it stands.
BOOST_DATA_TEST_CASE(help_has_examples_that_work, boost::unit_test::data::make(kCommands), command) {
  const Outcome help = run(with(command, {"--help"}));
  BOOST_TEST(help.status == 0);
  BOOST_TEST(help.error == "");
  const Scratch scratch;
  std::filesystem::create_directory_symlink(std::string(FIBERCHAIN_SOURCE_DIR) + "/data",
                                            scratch.path / "data");
  int examples = 0;
  for (const std::string& line : lines(help.out)) {
    if (!line.starts_with("  fiberchain ")) continue;
    Command example = words(line);
    example.erase(example.begin());
    BOOST_TEST(run(example, {.directory = scratch.path}).status == 0, line);
    ++examples;
  }
  BOOST_TEST(examples >= 1);
}

BOOST_DATA_TEST_CASE(json_is_one_object_of_documented_columns_and_nothing_else,
                     boost::unit_test::data::make(kJsonCommands), command) {
  std::set<std::string> documented;
  for (const json& row : rows({"columns"})) documented.insert(row["column"].get<std::string>());
  const Scratch scratch;
  const Outcome outcome = run(with(command, {"--json"}), {.directory = scratch.path});
  BOOST_TEST(outcome.status == 0);
  const json document = json::parse(outcome.out);  // throws unless it is exactly one value
  BOOST_TEST(document["provenance"]["program"] == "fiberchain");
  BOOST_TEST(!document["rows"].empty());
  for (const auto& [name, rows] : document.items()) {
    for (const json& row : name == "provenance" ? json::array() : rows) {
      for (const auto& [key, value] : row.items()) BOOST_TEST(documented.count(key) == 1, key);
    }
  }
  BOOST_TEST(files_under(scratch.path) == 0);
  BOOST_TEST(outcome.error.find('*') == std::string::npos);  // no progress bar in a pipe
}

BOOST_AUTO_TEST_CASE(files_carry_their_provenance) {
  const Scratch scratch;
  const std::string scene = kScenes + "cantilever.yaml";
  const Outcome outcome = run({"run", scene}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 0);
  for (const char* name : {"cantilever.csv", "cantilever-shape.csv", "cantilever.md", "cantilever-shape.svg",
                           "cantilever-shape.png"}) {
    const std::string text = content(scratch.path / "results" / name);
    BOOST_TEST(text.find("run " + scene) != std::string::npos, name);
    BOOST_TEST(text.find("commit") != std::string::npos, name);
    BOOST_TEST(outcome.error.find(name) != std::string::npos, name);
  }
  BOOST_TEST(files_under(scratch.path) == 5);
}

// What CSV and JSON print of a double reads back to the same bits, so the two must agree to the letter.
BOOST_AUTO_TEST_CASE(json_and_csv_hold_the_same_numbers) {
  const Scratch scratch;
  const Command command = {"tables", "static", "--aspect-ratio", "7",    "--load",
                           "0.3,2",  "--json", "--out",          "there"};
  const Outcome outcome = run(command, {.directory = scratch.path});
  const json row = json::parse(outcome.out)["rows"][1];
  std::vector<std::string> csv = lines(content(scratch.path / "there/static.csv"));
  std::erase_if(csv, [](const std::string& line) { return line.starts_with('#'); });
  BOOST_REQUIRE(csv.size() == 3);
  std::istringstream names(csv[0]), values(csv[2]);
  int compared = 0;
  for (std::string name, value; std::getline(names, name, ',') && std::getline(values, value, ',');) {
    if (!row[name].is_number()) continue;
    BOOST_TEST(row[name].get<double>() == std::stod(value), name);
    ++compared;
  }
  BOOST_TEST(compared > 20);
}

// The exact small-load departure of the chain, (3E/(16G) - 1/4)/r_f^2 with E/G = 2(1 + nu); the next term is
// of order load^2 relative to it.
BOOST_AUTO_TEST_CASE(the_chain_departs_from_the_elastica_as_theory_says) {
  for (const json& row : rows({"tables", "static", "--aspect-ratio", "10,13", "--poisson-ratio", "0.17,0.3",
                               "--load", "1e-3"})) {
    const double ratio = row["aspect_ratio"].get<double>();
    const double expected = (0.375 * (1 + row["poisson_ratio"].get<double>()) - 0.25) / (ratio * ratio);
    BOOST_CHECK_CLOSE_FRACTION(row["departure_y"].get<double>(), expected, 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_sweep_is_every_combination_asked_for) {
  const json all = rows({"tables", "static", "--aspect-ratio", "5..7", "--load", "0.5,1", "--bond",
                         "paper,corrected", "--dimension", "planar,spatial"});
  std::set<std::string> seen;
  for (const json& row : all) {
    seen.insert(row["aspect_ratio"].dump() + row["load"].dump() + row["bond"].dump() +
                row["dimension"].dump());
  }
  BOOST_TEST(all.size() == 3 * 2 * 2 * 2);
  BOOST_TEST(seen.size() == all.size());
}

// At nu = 0.3 the limit is 0.2178 t_b with xi_b = 1 and lagged dashpots, and the undamped one with solved
// dashpots.
BOOST_AUTO_TEST_CASE(stability_finds_the_limits_and_judges_the_papers_rule) {
  const Scratch scratch;
  const std::vector<std::string> asked = {"stability",       "--aspect-ratio", "10",
                                          "--poisson-ratio", "0.3,0.4",        "--bond-damping",
                                          "0.2,1",           "--bond",         "paper"};
  std::vector<std::string> words = asked;
  words.insert(words.end(), {"--json", "--out", "there"});
  const Outcome outcome = run(words, {.directory = scratch.path});
  BOOST_REQUIRE_EQUAL(outcome.status, 0);
  const json all = json::parse(outcome.out)["rows"];
  BOOST_REQUIRE(all.size() == 8);
  BOOST_TEST(std::abs(all[1]["stable_step_measured"].get<double>() - 0.2182) < 0.0005);
  BOOST_TEST(all[1]["quarter_verdict"] == "unstable");
  BOOST_TEST(all[0]["quarter_verdict"] == "stable");
  for (const json& row : all) {
    BOOST_TEST(std::abs(row["stable_step_difference"].get<double>()) < 0.002);
    if (row["scheme"] == "leapfrog-damped") BOOST_TEST(row["stable_step_modes"].get<double>() > 1);
  }
  const std::string map = "there/stability-map-paper-leapfrog-10.svg";
  BOOST_TEST(!std::filesystem::exists(scratch.path / map));  // nobody asked for pictures
  std::vector<std::string> drawn = asked;
  drawn.insert(drawn.end(), {"--out", "there"});
  BOOST_REQUIRE_EQUAL(run(drawn, {.directory = scratch.path}).status, 0);
  BOOST_TEST(content(scratch.path / map).find(">0.218<") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_number_of_threads_changes_nothing) {
  const Command sweep = {"tables", "static",  "--aspect-ratio", "5,9",
                         "--load", "0.5,2,6", "--method",       "solve,march"};
  json one = rows(with(sweep, {"--jobs", "1"}));
  json three = rows(with(sweep, {"--jobs", "3"}));
  for (json* all : {&one, &three}) {
    for (json& row : *all) row.erase("run_time");
  }
  BOOST_TEST(one == three);
}

BOOST_AUTO_TEST_SUITE_END()
