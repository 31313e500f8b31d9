// Damped Euler-Bernoulli beam: CVODE against the modal closed form, and both against what is known exactly.
#include "reference/damped_beam.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(damped_beam_test)

namespace ref = fiberchain::reference;
using ref::BeamDamping;
using ref::BeamHistory;
using ref::Release;

namespace {

constexpr double omega_1 = 3.5160152685001513;  // beta_1^2

std::vector<double> periods(double count, int samples) {
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) times.push_back(count * 2 * std::numbers::pi / omega_1 * i / samples);
  return times;
}

double largest_difference(const BeamHistory& a, const BeamHistory& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    worst = std::max(worst, std::abs(a.samples[i].y - b.samples[i].y));
  }
  return worst;
}

constexpr Release loaded{Release::Shape::static_load, 0.37};

}  // namespace

BOOST_AUTO_TEST_CASE(frequencies_solve_their_equation) {
  // R. D. Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1
  constexpr std::array<double, 5> published{1.87510407, 4.69409113, 7.85475744, 10.99554073, 14.13716839};
  for (int n = 1; n <= 5; ++n) {
    BOOST_TEST(std::abs(ref::clamped_free_beta(n) - published[static_cast<std::size_t>(n - 1)]) < 0.51e-8);
  }
  for (int n = 1; n <= 20; ++n) {
    const double beta = ref::clamped_free_beta(n);
    BOOST_TEST(std::abs(std::cos(beta) + 1 / std::cosh(beta)) < 1e-14 * beta);
    if (n > 1) BOOST_TEST(std::abs(beta - ref::clamped_free_beta(n - 1) - std::numbers::pi) < 0.33);
  }
}

BOOST_AUTO_TEST_CASE(modal_form_starts_from_the_static_shape) {
  const ref::BeamSample start = ref::damped_beam_modal({0.01, 0.2}, loaded, {0}, 3000).samples[0];
  BOOST_TEST(std::abs(start.y - 0.37 / 3) < 0.37 * 4 / (3 * std::pow(std::numbers::pi, 4) * 2.6e10));
  BOOST_TEST(std::abs(start.angle - 0.37 / 2) < 1e-7);
  BOOST_TEST(std::abs(start.elastic - 0.37 * 0.37 / 6) < 1e-8);  // P y / 2
  BOOST_TEST(start.y_rate == 0);
  BOOST_TEST(start.kinetic + start.dissipated == 0);
}

BOOST_AUTO_TEST_CASE(cvode_equals_the_modal_form_over_twenty_periods) {
  const std::array<BeamDamping, 3> cases{
      {{2 * 0.05 / omega_1, 0}, {2 * 0.01 / omega_1, 0.31}, {0.0031, 0.07}}};
  for (const BeamDamping& damping : cases) {
    const std::vector<double> times = periods(20, 1500);
    const BeamHistory modal = ref::damped_beam_modal(damping, loaded, times, 6000);
    const BeamHistory cvode =
        ref::damped_beam_cvode(damping, loaded, times, {18, ref::CvodeMethod::bdf, {2e-12, 2e-14}});
    const double difference = largest_difference(modal, cvode);
    BOOST_TEST_MESSAGE("largest difference " << difference << " in " << cvode.statistics.steps << " steps");
    BOOST_TEST(difference < 1e-9 * 0.37);
    BOOST_TEST(difference > 0);
    const auto& last = cvode.samples.back();
    const double start = cvode.samples.front().elastic;
    BOOST_TEST(std::abs(last.kinetic + last.elastic + last.dissipated - start) < 1e-8 * start);
    BOOST_TEST(std::abs(last.dissipated - modal.samples.back().dissipated) < 1e-8 * start);
    BOOST_TEST(std::abs(last.angle - modal.samples.back().angle) < 1e-8);
    BOOST_TEST(cvode.statistics.steps > 1000);
    BOOST_TEST(cvode.statistics.jacobians > 0);
  }
}

BOOST_AUTO_TEST_CASE(error_falls_with_modes_and_with_tolerance) {
  const BeamDamping damping{2 * 0.02 / omega_1, 0};
  const std::vector<double> times = periods(3, 300);
  const BeamHistory modal = ref::damped_beam_modal(damping, loaded, times, 6000);
  const auto error = [&](int modes, double tolerance) {
    return largest_difference(
        modal, ref::damped_beam_cvode(damping, loaded, times,
                                      {modes, ref::CvodeMethod::bdf, {tolerance, tolerance / 100}}));
  };
  BOOST_TEST(error(4, 1e-11) > 20 * error(8, 1e-11));
  BOOST_TEST(error(8, 1e-11) > 5 * error(16, 1e-11));
  BOOST_TEST(error(16, 1e-7) > 20 * error(16, 1e-10));
}

BOOST_AUTO_TEST_CASE(first_mode_decays_by_its_damping_ratio) {
  const BeamDamping damping{0.013, 0.4};
  const double ratio = ref::damped_beam_ratio(damping, 1);
  BOOST_TEST(ratio == (0.4 / omega_1 + 0.013 * omega_1) / 2, boost::test_tools::tolerance(1e-12));
  const double root = std::sqrt(1 - ratio * ratio);
  const std::vector<double> after_three{6 * std::numbers::pi / (omega_1 * root)};
  const double expected = 0.2 * std::exp(-6 * std::numbers::pi * ratio / root);
  const Release mode{Release::Shape::first_mode, 0.2};
  BOOST_TEST(ref::damped_beam_modal(damping, mode, after_three).samples[0].y == expected,
             boost::test_tools::tolerance(1e-12));
  const auto cvode =
      ref::damped_beam_cvode(damping, mode, after_three, {12, ref::CvodeMethod::bdf, {1e-12, 1e-14}});
  BOOST_TEST(cvode.samples[0].y == expected, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(every_kind_of_damping_of_the_first_mode_from_under_to_over) {
  const Release mode{Release::Shape::first_mode, 0.2};
  const std::vector<double> times = periods(1.7, 40);
  for (const double ratio : {0.0, 0.3, 0.999, 1.0, 1.0 + 1e-9, 1.04, 2.7}) {
    const BeamDamping damping{2 * ratio / omega_1, 0};
    const BeamHistory modal = ref::damped_beam_modal(damping, mode, times);
    const BeamHistory cvode =
        ref::damped_beam_cvode(damping, mode, times, {8, ref::CvodeMethod::bdf, {1e-11, 1e-13}});
    BOOST_TEST(largest_difference(modal, cvode) < 2e-9, "damping ratio " << ratio);
    const bool crosses =
        std::any_of(modal.samples.begin(), modal.samples.end(), [](auto& s) { return s.y < 0; });
    BOOST_TEST(crosses == (ratio < 0.9));
    for (std::size_t i = 0; i < times.size(); i += 7) {
      const auto& s = modal.samples[i];
      BOOST_TEST(std::abs(s.y_rate - cvode.samples[i].y_rate) < 1e-8);
      BOOST_TEST(std::abs(s.kinetic + s.elastic + s.dissipated - 0.2 * 0.2 / 8 * omega_1 * omega_1) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(undamped_beam_returns_after_a_period) {
  const std::vector<double> times = periods(5, 5);
  const auto cvode = ref::damped_beam_cvode({}, {Release::Shape::first_mode, 0.3}, times,
                                            {7, ref::CvodeMethod::adams, {1e-11, 1e-13}});
  for (const auto& sample : cvode.samples) BOOST_TEST(std::abs(sample.y - 0.3) < 1e-8);
  BOOST_TEST(cvode.samples.back().dissipated == 0);
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
  const std::vector<double> times{0, 1};
  BOOST_CHECK_THROW(ref::damped_beam_modal({-0.1, 0}, loaded, times), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_beam_cvode({0, NAN}, loaded, times), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_beam_cvode({0.1, 0}, {Release::Shape::static_load, INFINITY}, times),
                    ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_beam_modal({0.1, 0}, loaded, {1, 1}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_beam_cvode({0.1, 0}, loaded, {-1, 1}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_beam_cvode({0.1, 0}, loaded, {0, NAN}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_beam_cvode({0.1, 0}, loaded, times, {1}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::damped_beam_cvode({0.1, 0}, loaded, times, {61}), ref::InvalidArgument);
  BOOST_CHECK_THROW(ref::clamped_free_beta(0), ref::InvalidArgument);
}

BOOST_AUTO_TEST_SUITE_END()
