// The manual page and the completions of shells against --help, which CLI11 writes; bash itself completes.
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <set>
#include <sstream>

#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(documentation_test)

using namespace fiberchain::test;

namespace {

using Words = std::set<std::string>;

/// All words of a text that begin with two dashes.
Words options_in(const std::string& text) {
  Words found;
  for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at), text.size());
    if (end > at + 2) found.insert(text.substr(at, end - at));
    at = end;
  }
  return found;
}

/// Those that help lists at the begin of a line, and what stands behind a comma.
Words options_of(const std::vector<std::string>& command) {
  std::vector<std::string> arguments = command;
  arguments.emplace_back("--help");
  std::istringstream lines(run(arguments).out);
  Words found;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == 2 && line[begin] == '-')
      found.merge(options_in(line.substr(begin, line.find(' ', begin) - begin)));
  }
  return found;
}

std::string manual_without_escapes() {
  std::string text = run({"manual"}).out;
  for (std::size_t at = 0; (at = text.find("\\-", at)) != std::string::npos;) text.erase(at, 1);
  return text;
}

/// What bash offers for the last of these words.
Words offered(const std::string& words) {
  const Scratch scratch;
  const auto script = scratch.file("completion.bash", run({"completion", "bash"}).out);
  const std::string out = (scratch.path / "out").string();
  const auto ask =
      scratch.file("ask.bash", "set -eu\nsource " + script.string() + "\nCOMP_WORDS=(fiberchain " + words +
                                   ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_fiberchain\n"
                                   "printf '%s\\n' \"${COMPREPLY[@]}\" > " +
                                   out + "\n");
  BOOST_TEST_REQUIRE(std::system(("bash " + ask.string()).c_str()) == 0);
  std::istringstream lines(content(out));
  Words found;
  for (std::string line; std::getline(lines, line);) found.insert(line);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(manual_and_completion_have_every_option_of_the_help) {
  const std::string manual = manual_without_escapes();
  const Words in_manual = options_in(manual);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"run"}, {"tables", "static"}, {"calibrate"}, {"validate"}}) {
    std::string typed;
    for (const std::string& word : command) typed += word + " ";
    const Words expected = options_of(command);
    BOOST_TEST_REQUIRE(expected.size() > 4u);
    BOOST_TEST(offered(typed + "--") == expected, boost::test_tools::per_element());
    for (const std::string& option : expected) BOOST_TEST(in_manual.contains(option), option);
    BOOST_TEST(manual.find(".SS " + typed.substr(0, typed.size() - 1) + "\n") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(commands_are_completed) {
  BOOST_TEST((offered("cal") == Words{"calibrate"}));
  BOOST_TEST((offered("tables st") == Words{"static"}));
  BOOST_TEST(offered("tables \"\"").contains("contact-modulus"));
  BOOST_TEST(offered("\"\"").contains("tables"));
}

BOOST_AUTO_TEST_CASE(lines_of_the_manual_are_text_or_requests_that_are_known) {
  const Words known{".TH", ".SH", ".SS", ".TP", ".PP", ".B", ".I", ".RI", ".nf", ".fi"};
  std::istringstream lines(run({"manual"}).out);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('.')) BOOST_TEST(known.contains(line.substr(0, line.find(' '))), line);
    BOOST_TEST(!line.starts_with('\''), line);
  }
}

BOOST_AUTO_TEST_CASE(shells_are_named) {
  for (const std::string shell : {"bash", "fish", "zsh"}) {
    const Outcome outcome = run({"completion", shell});
    BOOST_TEST(outcome.status == 0);
    BOOST_TEST(outcome.out.find("instruction-set") != std::string::npos);
  }
  const Outcome wrong = run({"completion", "csh"});
  BOOST_TEST(wrong.status == 2);
  BOOST_TEST(is_one_error(wrong.error));
  BOOST_TEST(wrong.error.find("allowed: bash, fish, zsh") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
