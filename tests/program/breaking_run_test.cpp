// A run whose bonds break, with its files: killed and resumed it ends the same.
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "tests/program/packings.hpp"

BOOST_AUTO_TEST_SUITE(breaking_run_test)

using namespace fiberchain::test;

namespace {

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

std::string brittle_fibers() {
  std::string scene = short_fibers(15000, few);
  const std::string bond = "bond: {damping: 1}";
  scene.replace(
      scene.find(bond), bond.size(),
      "bond: {damping: 1, strength: {tension: 20 kPa, compression: 40 kPa, shear: 20 kPa, torsion: 20 "
      "kPa, weibull: {modulus: 3, seed: 5}}, yield: {stress: 30 kPa, hardening: 0.1}}");
  return scene;
}

struct BrittleFibers : FewFibers {
  BrittleFibers() { file("s.yaml", brittle_fibers()); }
};

/// Lines without comments and header.
std::vector<std::string> rows_of(const std::filesystem::path& path) {
  std::istringstream text(content(path));
  std::vector<std::string> rows;
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with('#')) rows.push_back(line);
  }
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_CASE(killed_and_resumed_it_ends_the_same_with_its_breaks) {
  BrittleFibers whole, killed;
  const Outcome outcome = whole.go();
  BOOST_TEST_REQUIRE(outcome.status == 0, outcome.error);
  BOOST_TEST(kill_and_resume(killed, {0, 7, 31}) >= 2);
  BOOST_TEST(same_end(whole, killed));
  const auto rows = rows_of(whole.out("s-breaks.csv"));
  BOOST_TEST(rows == rows_of(killed.out("s-breaks.csv")), boost::test_tools::per_element());
  BOOST_TEST(
      rows.at(0) ==
      "step,simulated_time,break_fiber,break_bond,break_cause,break_stress,break_energy,break_x,break_y,"
      "break_z");
  BOOST_TEST(rows.size() > 5u);
  const auto log = rows_of(whole.out("s-log.csv"));
  BOOST_TEST(holds(log.at(0), ",pieces,"));
  BOOST_TEST(holds(log.at(0), "taken_breaking"));
  BOOST_TEST(holds(log.back(), "," + std::to_string(31 + rows.size() - 1) + ","), log.back());
}

BOOST_AUTO_TEST_CASE(a_run_without_strengths_has_no_such_files) {
  FewFibers plain(300);
  BOOST_TEST(plain.go().status == 0);
  BOOST_TEST(!std::filesystem::exists(plain.out("s-breaks.csv")));
  BOOST_TEST(!holds(rows_of(plain.out("s-log.csv")).at(0), "pieces"));
}

BOOST_AUTO_TEST_SUITE_END()
