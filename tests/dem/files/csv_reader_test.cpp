// Quoted fields (RFC 4180), which hold commas, quotes and line ends.
#include "dem/files/csv_reader.hpp"

#include <boost/test/unit_test.hpp>
#include <sstream>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(csv_reader_test)

namespace dem = fiberchain::dem;

namespace {

using Record = std::vector<std::string>;

dem::CsvReader reader_of(std::istream& text) {
  return {text, "x.csv", [](const std::string& what) { throw std::runtime_error(what); }};
}

std::string refusal(const std::string& text) {
  std::istringstream input(text);
  dem::CsvReader reader = reader_of(input);
  try {
    while (reader.record()) continue;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_quoted_field_goes_on_over_lines) {
  std::istringstream input("a,\"one, \"\"two\"\"\n\nthree\",b\r\n# c\n\"\",last\n");
  dem::CsvReader reader = reader_of(input);
  const auto first = reader.record();
  BOOST_TEST((first == Record{"a", "one, \"two\"\n\nthree", "b"}));
  BOOST_TEST(reader.line_number() == 1u);
  const auto second = reader.record();
  BOOST_TEST((second == Record{"", "last"}));
  BOOST_TEST(reader.line_number() == 5u);
  BOOST_TEST(reader.comments().size() == 1u);
  BOOST_TEST(!reader.record());
}

BOOST_AUTO_TEST_CASE(what_is_quoted_wrong_is_refused_with_its_line) {
  BOOST_TEST(refusal("a\n\"b\nc\n") == "x.csv:3: a quoted field is not closed");
  BOOST_TEST(refusal("a\n\"b\"c\n") == "x.csv:2: text after a quoted field");
  BOOST_TEST(refusal("a\n\"b\"\n") == "none");
}

BOOST_AUTO_TEST_SUITE_END()
