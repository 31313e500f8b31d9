#include "compare/study/ranges.hpp"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(ranges_test)

using namespace fiberchain::compare;

namespace {

constexpr ValueRange kAny{.low = -1e9, .high = 1e9};

struct Good {
  const char* text;
  std::vector<double> values;
};
std::ostream& operator<<(std::ostream& out, const Good& good) { return out << good.text; }

const Good kGood[] = {
    {"10", {10}},
    {"10,13", {10, 13}},
    {"5..8", {5, 6, 7, 8}},
    {"0.5..2.25", {0.5, 1.5}},
    {"5..20:5", {5, 10, 15, 20}},
    {"0..0.3:0.1", {0, 0.1, 0.2, 0.3}},
    {"-0.2..0.4:0.3", {-0.2, 0.1, 0.4}},
    {"7..7", {7}},
    {"1..100:log:3", {1, 10, 100}},
    {"0..1:lin:3", {0, 0.5, 1}},
    {"1,3..5,2e1", {1, 3, 4, 5, 20}},
};

struct Bad {
  const char* text;
  const char* says;
};
std::ostream& operator<<(std::ostream& out, const Bad& bad) { return out << bad.text; }

const Bad kBad[] = {
    {"", "--load: '' is no number"},
    {"x", "--load: 'x' is no number"},
    {"1,", "--load: '' is no number"},
    {"1 2", "--load: '1 2' is no number"},
    {"5..", "--load: '' is no number"},
    {"5..1", "--load: '5..1' runs backward"},
    {"1..2..3", "--load: '1..2..3' is no range"},
    {"5:0..3", "--load: '5:0..3' is no range"},
    {"1..5:0", "--load: '1..5:0' wants a step above 0"},
    {"1..5:-1", "--load: '1..5:-1' wants a step above 0"},
    {"1..5:nan", "--load: '1..5:nan' wants a step above 0"},
    {"1..5:1e-9", "--load: '1..5:1e-9' has more than 100000 values"},
    {"1..5:log:1", "--load: '1..5:log:1' wants a number of values"},
    {"1..5:log:1e3", "--load: '1..5:log:1e3' wants a number of values"},
    {"0..5:log:4", "--load: '0..5:log:4' is logarithmic"},
    {"1..5:geo:4", "--load: '1..5:geo:4' has no such spacing"},
    {"1..5:log:4:2", "--load: '1..5:log:4:2' is no range"},
    {"inf", "--load: 'inf' is out of range; allowed: a number at least 0 and below 1000"},
    {"nan", "--load: 'nan' is out of range"},
    {"-1", "--load: '-1' is out of range"},
    {"1000", "--load: '1000' is out of range"},
    {"0..1001", "--load: '1001' is out of range"},
};

}  // namespace

BOOST_DATA_TEST_CASE(lists_and_ranges_give_the_values_meant, boost::unit_test::data::make(kGood), good) {
  const std::vector<double> values = parse_numbers("--load", good.text, kAny);
  BOOST_TEST(values.size() == good.values.size());
  for (std::size_t i = 0; i < std::min(values.size(), good.values.size()); ++i) {
    // What could have been typed is what comes out, to the bit; logarithmic values in between are rounded.
    if (std::string_view(good.text).find("log") == std::string_view::npos)
      BOOST_TEST(values[i] == good.values[i]);
    BOOST_CHECK_CLOSE_FRACTION(values[i], good.values[i], 1e-15);
  }
}

BOOST_DATA_TEST_CASE(what_is_no_list_is_refused_with_option_value_and_reason,
                     boost::unit_test::data::make(kBad), bad) {
  BOOST_CHECK_EXCEPTION(
      parse_numbers("--load", bad.text, {.low = 0, .high = 1000, .high_open = true}), InputError,
      [&](const InputError& error) { return std::string(error.what()).starts_with(bad.says); });
}

BOOST_AUTO_TEST_CASE(logarithmic_ranges_have_equal_ratios_and_exact_ends) {
  const auto values = parse_numbers("--load", "0.05..10:log:12", kAny);
  BOOST_TEST(values.size() == 12);
  BOOST_TEST(values.front() == 0.05);
  BOOST_TEST(values.back() == 10.0);
  for (std::size_t i = 1; i < values.size(); ++i) {
    BOOST_CHECK_CLOSE_FRACTION(values[i] / values[i - 1], std::pow(200., 1. / 11), 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(integers_are_whole) {
  const std::vector<int> expected = {4, 10, 11, 12};
  BOOST_TEST(parse_integers("--aspect-ratio", "4,10..12", {.low = 1, .high = 100}) == expected,
             boost::test_tools::per_element());
  BOOST_CHECK_THROW(parse_integers("--aspect-ratio", "4.5", {.low = 1, .high = 100}), InputError);
  BOOST_CHECK_THROW(parse_integers("--aspect-ratio", "1..3:0.5", {.low = 1, .high = 100}), InputError);
}

BOOST_AUTO_TEST_CASE(words_are_of_those_allowed) {
  const std::vector<std::string> expected = {"march", "solve"};
  BOOST_TEST(parse_words("--method", "march,solve", {"solve", "march"}) == expected,
             boost::test_tools::per_element());
  BOOST_CHECK_EXCEPTION(parse_words("--method", "guess", {"solve", "march"}), InputError,
                        [](const InputError& error) {
                          return std::string(error.what()) == "--method: 'guess' is not among solve, march";
                        });
}

BOOST_AUTO_TEST_SUITE_END()
