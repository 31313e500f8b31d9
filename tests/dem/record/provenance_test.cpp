#include "dem/record/provenance.hpp"

#include <stdlib.h>

#include <boost/test/unit_test.hpp>
#include <map>
#include <regex>

#include "dem/files/sha256.hpp"

BOOST_AUTO_TEST_SUITE(provenance_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::dem;

// FIPS 180-2, appendix B.1 and B.3; the empty text as `sha256sum /dev/null` prints it.
BOOST_AUTO_TEST_CASE(sha256_is_the_standard_one) {
  BOOST_TEST(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  BOOST_TEST(sha256(std::string(1000000, 'a')) ==
             "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  BOOST_TEST(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

BOOST_AUTO_TEST_CASE(every_fact_of_a_run_is_there) {
  ::unsetenv("SOURCE_DATE_EPOCH");
  const dem::Provenance provenance =
      dem::with_scene(dem::collect_provenance({"fiberchain", "run"}), "a/b.yaml", "abc");
  std::map<std::string, std::string> found;
  for (const auto& [key, value] : dem::entries(provenance)) found[key] = value;
  BOOST_TEST(found.size() == 10);
  BOOST_TEST(std::regex_match(found["version"], std::regex("\\d+\\.\\d+\\.\\d+")));
  BOOST_TEST(std::regex_match(found["commit"], std::regex("unknown|[0-9a-f]{40}(-dirty)?")));
  BOOST_TEST(std::regex_match(found["date"], std::regex("\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ")));
  BOOST_TEST(found["flags"].find("-ffp-contract=off") != std::string::npos);
  BOOST_TEST(!found["cpu"].empty());
  BOOST_TEST(!found["compiler"].empty());
  BOOST_TEST(found["scene"] == "a/b.yaml");
  BOOST_TEST(found["scene_sha256"] == sha256("abc"));
}

BOOST_AUTO_TEST_CASE(the_command_can_be_pasted_into_a_shell) {
  const auto command = [](std::vector<std::string> words) { return dem::collect_provenance(words).command; };
  BOOST_TEST(command({"fiberchain", "tables", "--load", "0.05..10:log:12"}) ==
             "fiberchain tables --load 0.05..10:log:12");
  BOOST_TEST(command({"a b", "", "it's", "$x"}) == "'a b' '' 'it'\\''s' '$x'");
}

BOOST_AUTO_TEST_CASE(values_stay_on_one_line) {
  dem::Provenance provenance;
  provenance.command = "a\nb\x7f\tc";
  BOOST_TEST(dem::entries(provenance).back().second == "a?b??c");
}

BOOST_AUTO_TEST_CASE(the_date_can_be_fixed_for_reproduction) {
  ::setenv("SOURCE_DATE_EPOCH", "1424649600", 1);
  BOOST_TEST(dem::collect_provenance({}).date == "2015-02-23T00:00:00Z");
}

BOOST_AUTO_TEST_SUITE_END()
