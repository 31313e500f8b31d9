// What is said of overlaps: limits of impacts and of rest.
#include "dem/run/overlaps.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(overlaps_test)

namespace dem = fiberchain::dem;

namespace {

/// Kinetic energy 1 nJ.
dem::RunMoment moment(double peak, double mean, double stored) {
  dem::RunMoment now{};
  now.overlap_peak = peak, now.overlap_mean = mean;
  now.energy.kinetic = 1e-9, now.energy.contacts = stored;
  return now;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(an_impact_is_warned_of_beyond_a_tenth_of_the_radius) {
  BOOST_TEST(dem::impact_warning(moment(0.0999, 0, 0)) == "");
  const std::string warning = dem::impact_warning(moment(0.123, 0, 0));
  BOOST_TEST(has(warning, "warning: a contact has overlapped by 0.12 of the smaller radius"), warning);
  BOOST_TEST(has(warning, "contacts.youngs_modulus"), warning);
}

BOOST_AUTO_TEST_CASE(a_mean_overlap_is_warned_of_beyond_a_hundredth_and_at_rest_alone) {
  BOOST_TEST(dem::rest_warning(moment(0, 0.0099, 2e-9)) == "");
  BOOST_TEST(dem::rest_warning(moment(0, 0.021, 0.9e-9)) == "");  // more energy moves
  BOOST_TEST(!dem::presses_at_rest(moment(0, 0.021, 0.9e-9)));
  BOOST_TEST(dem::presses_at_rest(moment(0, 0.021, 1.1e-9)));
  const std::string warning = dem::rest_warning(moment(0, 0.021, 1.1e-9));
  BOOST_TEST(has(warning, "warning: contacts at rest overlap by 0.021 of the smaller radius on average"),
             warning);
}

BOOST_AUTO_TEST_CASE(an_expected_impact_is_said_and_warned_of) {
  const std::string small = dem::expected_impact_in_words(0.271, 0.061);
  BOOST_TEST(small == "single spheres that meet at 0.271 m/s overlap by 0.061 of the smaller radius");
  const std::string large = dem::expected_impact_in_words(0.271, 0.104);
  BOOST_TEST(has(large, "overlap by 0.1 of the smaller radius; warning: beyond 0.1 contacts are too soft"),
             large);
}

BOOST_AUTO_TEST_SUITE_END()
