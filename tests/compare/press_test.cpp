// A plate on a bed of fibers: the fit of its pressure, and a small bed.
#include "compare/press/press.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/study/errors.hpp"

BOOST_AUTO_TEST_SUITE(press_test)

using namespace fiberchain::compare;

namespace {

std::vector<PressSample> samples_of(double a, double n, double initial) {
  std::vector<PressSample> samples;
  for (int i = 0; i < 40; ++i) {
    const double phi = 0.08 + 0.003 * i;
    samples.push_back({phi, a * (std::pow(phi, n) - std::pow(initial, n)), 0});
  }
  return samples;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_law_is_found_again) {
  for (const double n : {2.7, 3.0, 5.3}) {
    const PressFit fit = fit_press(samples_of(3.1e5, n, 0.043), 1.7e7, 0.08, 0.2);
    BOOST_TEST(std::abs(fit.exponent - n) < 1e-4);
    BOOST_TEST(std::abs(fit.initial_fraction - 0.043) < 1e-4);
    BOOST_TEST(std::abs(fit.stiffness / (3.1e5 / 1.7e7) - 1) < 1e-3);
    BOOST_TEST(fit.residual < 1e-5);
    BOOST_TEST(fit.points == 40);
  }
  std::vector<PressSample> empty_at_first = samples_of(1e5, 3, 0.05);
  empty_at_first[2].pressure = 0;
  BOOST_CHECK_THROW(fit_press(empty_at_first, 1e7, 0, 1), InputError);
  BOOST_TEST(fit_press(empty_at_first, 1e7, 0.09, 1).points == 36);
  BOOST_CHECK_THROW(fit_press(samples_of(1e5, 3, 0.05), 1e7, 0.19, 1), InputError);
}

BOOST_AUTO_TEST_CASE(a_small_bed_resists_the_plate) {
  std::vector<PressCase> cases = press_cases(50, 20, 0.3, 2, 2);
  const std::vector<PressRun> runs = run_presses(cases, 48, 1);
  BOOST_TEST_REQUIRE(runs.size() == 2u);
  for (const PressRun& run : runs) {
    BOOST_TEST(run.status == "finished");
    BOOST_TEST_REQUIRE(run.samples.size() == 48u);
    BOOST_TEST(std::abs(run.samples.back().solid_fraction / run.asked.dense - 1) < 0.1);
    BOOST_TEST(run.samples.back().pressure > 20 * std::abs(run.samples[20].pressure));
    BOOST_TEST(std::abs(run.samples.back().floor_pressure / run.samples.back().pressure - 1) < 0.5);
  }
  BOOST_TEST(runs[0].samples.back().pressure != runs[1].samples.back().pressure);
  BOOST_TEST(press_table(runs).rows().size() == 2u);
  BOOST_TEST(press_sample_table(runs).rows().size() == 96u);
}

BOOST_AUTO_TEST_SUITE_END()
