#include <boost/test/unit_test.hpp>

#include "dem/scene/scene_error.hpp"
#include "dem/scene/strict_mapping.hpp"

BOOST_AUTO_TEST_SUITE(strict_mapping_test)

namespace dem = fiberchain::dem;

namespace {

const dem::StrictMapping kMapping(R"(size: 3 mm
count: 4
word: short
flag: true
list: [1 m, 2 cm]
axis: [0, 3, 4]
nested: {a: 1, b: 2}
several: [{a: 1}, {a: 2}]
)",
                                  "test.yaml");

/// What the call throws says.
template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const dem::SceneError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(values_arrive_in_si_units) {
  BOOST_TEST(kMapping.quantity("size", "m", dem::kPositive) == 3e-3);
  BOOST_TEST(kMapping.integer("count", {.low = 1, .high = 4}) == 4);
  BOOST_TEST(kMapping.word("word") == "short");
  BOOST_TEST(kMapping.choice("word", {"long", "short"}) == 1u);
  BOOST_TEST(kMapping.flag("flag"));
  BOOST_TEST(kMapping.quantities("list", "m", 2)[1] == 0.02);
  BOOST_TEST(kMapping.direction("axis")[2] == 0.8, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(kMapping.mapping("nested", {"a", "b"}).number("b", dem::kFinite) == 2);
  BOOST_TEST(kMapping.mappings("several", {"a"}).at(1).number("a", dem::kFinite) == 2);
  BOOST_TEST(kMapping.one_of({"size", "length"}) == "size");
}

BOOST_AUTO_TEST_CASE(errors_name_file_line_and_path) {
  BOOST_TEST(error_of([] {
               kMapping.allow({"size", "count"});
             }) == "test.yaml:3: unknown key 'word'; allowed: size, count");
  BOOST_TEST(error_of([] { kMapping.quantity("count", "m", {.low = 0, .high = 3}); }) ==
             "test.yaml:2: count: '4' is out of range; allowed: a number at least 0 and at most 3, in m");
  BOOST_TEST(error_of([] { kMapping.quantity("length", "m", dem::kPositive); }) ==
             "test.yaml:1: key 'length' is missing");
  BOOST_TEST(error_of([] {
               kMapping.mapping("nested", {"a", "c"});
             }) == "test.yaml:7: unknown key 'nested.b'; did you mean 'a'?");
  BOOST_TEST(error_of([] { kMapping.mapping("nested").fail("a", "is wrong"); }) ==
             "test.yaml:7: nested.a: is wrong");
  BOOST_TEST(error_of([] { kMapping.mappings("several", {"a"})[1].fail_missing("b"); }) ==
             "test.yaml:8: several[1]: key 'b' is missing");
  BOOST_TEST(error_of([] {
               kMapping.one_of({"size", "count"});
             }) == "test.yaml:1: must have exactly one of size, count");
  BOOST_TEST(error_of([] { kMapping.direction("list"); }) ==
             "test.yaml:5: list: must be three finite numbers such as [0, 1, 0]");
}

BOOST_AUTO_TEST_SUITE_END()
