// Laws of the damping: planted parameters come back, the chain's own data tell the laws apart, the paper's Eq
// 20 is local.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "compare/fit/choices.hpp"
#include "compare/fit/fit.hpp"
#include "compare/fit/table.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/static_release.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "reference/chain_modes.hpp"
#include "tests/compare/messages.hpp"

BOOST_AUTO_TEST_SUITE(damping_fit_test)

using namespace fiberchain;
using namespace fiberchain::compare;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const ChainKind kind{0.17, 0.7};

std::vector<DampingDatum> chain_data(const std::vector<int>& aspect_ratios) {
  std::vector<DampingDatum> points;
  for (const int r_f : aspect_ratios) points.push_back({r_f, linear_chain_slope(r_f, kind)});
  return points;
}

std::vector<int> every(int first, int last) {
  std::vector<int> values;
  for (int r_f = first; r_f <= last; ++r_f) values.push_back(r_f);
  return values;
}

std::vector<DampingDatum> law_data(DampingLaw law, const std::vector<double>& parameters) {
  std::vector<DampingDatum> points;
  for (const int r_f : {5, 6, 7, 9, 11, 13, 17, 21, 30})
    points.push_back({r_f, damping_law(law, parameters, r_f)});
  return points;
}

const DampingFit& find(const std::vector<DampingFit>& fits, DampingLaw law, FitKind way) {
  return *std::ranges::find_if(
      fits, [&](const DampingFit& f) { return f.model.law == law && f.model.kind == way; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(planted_parameters_come_back) {
  const std::vector<std::pair<DampingLaw, std::vector<double>>> planted{
      {DampingLaw::exponential, {0.031, 0.17}},
      {DampingLaw::power, {0.93, 2.13}},
      {DampingLaw::shifted_square, {0.71}}};
  for (const auto& [law, parameters] : planted) {
    for (const FitKind way : {FitKind::unweighted, FitKind::logarithmic}) {
      const DampingFit fit = fit_damping({law, way}, law_data(law, parameters));
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        BOOST_TEST(std::abs(fit.parameters[i] / parameters[i] - 1) < 1e-11);
        BOOST_TEST(fit.half_widths[i] < 1e-11 * parameters[i]);
      }
      BOOST_TEST(fit.fitted.rms < 1e-12);
    }
  }
}

// Three points, two parameters, by hand: ln y = ln a - b x at x = 1, 2, 3 with y = e^0, e^-1, e^-3.
BOOST_AUTO_TEST_CASE(intervals_and_criterion_are_those_of_a_straight_line) {
  const std::vector<DampingDatum> points{{1, 1.0}, {2, std::exp(-1)}, {3, std::exp(-3)}};
  const DampingFit fit = fit_damping({DampingLaw::exponential, FitKind::logarithmic}, points);
  // slope -3/2, intercept 5/3, residuals 1/6, -1/3, 1/6: RSS = 1/6; variances 1/6 (1/3 + 4/2) and 1/6 / 2
  const double a = std::exp(5.0 / 3), t = 12.7062047361747;  // Student, one degree, 97.5 %
  BOOST_TEST(std::abs(fit.parameters[0] / a - 1) < 1e-10);
  BOOST_TEST(std::abs(fit.parameters[1] / 1.5 - 1) < 1e-10);
  BOOST_TEST(std::abs(fit.half_widths[0] / (t * a * std::sqrt(7.0 / 18)) - 1) < 1e-8);
  BOOST_TEST(std::abs(fit.half_widths[1] / (t * std::sqrt(1.0 / 12)) - 1) < 1e-8);
  BOOST_TEST(std::abs(fit.covariance[0][1] / (a * 2 / 12.0) - 1) < 1e-8);
  BOOST_TEST(std::isnan(fit.information_criterion));  // n = 3 < k + 2
  // one parameter: n = 4, k = 2
  const std::vector<DampingDatum> four{{5, 0.03}, {7, 0.013}, {9, 0.009}, {11, 0.006}};
  for (const FitKind way : {FitKind::unweighted, FitKind::logarithmic}) {
    const DampingFit square = fit_damping({DampingLaw::shifted_square, way}, four);
    double rss = 0, change = 0;
    for (const DampingDatum& p : four) {
      const double y = damping_law(DampingLaw::shifted_square, square.parameters, p.aspect_ratio);
      rss += std::pow(way == FitKind::unweighted ? y - p.slope : std::log(y / p.slope), 2);
      change += way == FitKind::unweighted ? 0 : 2 * std::log(p.slope);
    }
    BOOST_TEST(std::abs(square.information_criterion - (4 * std::log(rss / 4) + 4 + 12 + change)) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(chain_data_tell_the_laws_apart) {
  const auto fits = damping_fits(chain_data(every(5, 30)), chain_data({40, 60}), chain_curve(kind));
  BOOST_REQUIRE(fits.size() == 8u);
  for (const FitKind way : {FitKind::unweighted, FitKind::logarithmic}) {
    const DampingFit& exponential = find(fits, DampingLaw::exponential, way);
    const DampingFit& power = find(fits, DampingLaw::power, way);
    const DampingFit& square = find(fits, DampingLaw::shifted_square, way);
    BOOST_TEST(std::abs(square.parameters[0] - 0.5) < 0.05);
    BOOST_TEST(std::abs(square.fitted.largest) < 0.0025);
    BOOST_TEST(std::abs(square.held_out.largest) < 0.0025);
    BOOST_TEST(square.information_criterion < power.information_criterion - 100);
    BOOST_TEST(power.information_criterion < exponential.information_criterion - 50);
    // the exponential does not fit: intervals of tens of percent, and nothing left at r_f = 60
    BOOST_TEST(exponential.half_widths[0] > 0.1 * exponential.parameters[0]);
    BOOST_TEST(std::abs(exponential.fitted.largest) > 0.2);
    BOOST_TEST(exponential.held_out.largest < -0.9);
    // 3 ... 500
    BOOST_REQUIRE(square.within_1.size() == 1u);
    BOOST_TEST(square.within_1[0].first == 3);
    BOOST_TEST(square.within_1[0].last == 500);
    BOOST_TEST(describe(exponential.within_20) != describe(square.within_20));
  }
}

BOOST_AUTO_TEST_CASE(equation_20_is_local) {
  const DampingFit paper = judge(published_law(chain_data({8, 9, 10, 15, 30})), {}, chain_curve({0.3, 1}));
  BOOST_TEST(std::abs(1 / (1 + paper.fitted.residuals[4]) - 2.9) < 0.1);  // 3 times too low at r_f = 30
  BOOST_TEST(describe(paper.within_5) == "9..10, 14..16");
  BOOST_TEST(describe(paper.within_20) == "7..19");
  BOOST_TEST(std::isnan(paper.held_out.rms));
  BOOST_TEST(paper.half_widths.empty());
  const DampingFit half = judge(derived_law(chain_data(every(5, 60))), {}, chain_curve({0.3, 1}));
  BOOST_TEST(std::abs(half.fitted.largest) < 0.0025);
  BOOST_TEST(std::abs(half.fitted.largest) > 1e-5);
}

BOOST_AUTO_TEST_CASE(regions_and_lists_read_as_ranges) {
  BOOST_TEST(describe(std::vector<AspectRange>{}) == "nowhere");
  BOOST_TEST(describe(std::vector<AspectRange>{{3, 5}, {8, 8}}) == "3..5, 8");
  BOOST_TEST(describe(std::vector<int>{8, 10, 15}) == "8,10,15");
  BOOST_TEST(describe(every(5, 30)) == "5..30");
  BOOST_TEST(describe(std::vector<int>{8, 10, 12, 14, 16, 18}) == "8..18:2");
}

BOOST_AUTO_TEST_CASE(slope_of_the_linear_chain_does_not_depend_on_scale) {
  dem::Fiber fiber = nominal_fiber(13, kind.poisson_ratio, dem::BondModel::paper);
  fiber.bond_damping = kind.bond_damping;
  const double twin = reference::first_bending_mode(linear_chain_of(fiber)).damping / kind.bond_damping;
  BOOST_TEST(std::abs(linear_chain_slope(13, kind) / twin - 1) < 1e-12);
}

BOOST_AUTO_TEST_CASE(choices_are_many_and_recover_the_law_planted_in_their_data) {
  const auto choices = fit_choices();
  BOOST_TEST(choices.size() >= 8u);
  int calls = 0;
  const auto planted = [&](const std::vector<SlopeRequest>& requests) {
    ++calls;
    std::vector<double> values;
    for (const SlopeRequest& r : requests) {
      values.push_back(damping_law(DampingLaw::exponential, {kPaperA, kPaperB}, r.aspect_ratio) *
                       (1 + 0.01 * r.peaks.first));
    }
    return values;
  };
  const auto outcomes = choice_outcomes(choices, planted);
  BOOST_REQUIRE(outcomes.size() == choices.size());
  BOOST_TEST(calls == 1);
  for (const ChoiceOutcome& o : outcomes) {
    BOOST_TEST(std::abs(o.departure_a - 0.01 * o.choice.peaks.first) < 1e-9);
    BOOST_TEST(std::abs(o.departure_b) < 1e-9);
    BOOST_TEST(std::abs(o.slope_8 / (kPaperA * std::exp(-kPaperB * 8) * (1 + 0.01 * o.choice.peaks.first)) -
                        1) < 1e-12);
  }
  BOOST_TEST(outcomes.front().choice.peaks.first == 0);  // nearest first
  BOOST_TEST(outcomes.back().choice.peaks.first == 1);
}

BOOST_AUTO_TEST_CASE(constant_force_is_a_load_that_grows_with_the_square_of_the_length) {
  const ChoiceLoad force{ChoiceLoad::Kind::force, 0.001};
  BOOST_TEST(std::abs(reduced_load(force, 10) / 0.19588 - 1) < 1e-4);  // P (r_f d)^2 / (E I)
  BOOST_TEST(std::abs(reduced_load(force, 30) / reduced_load(force, 10) - 9) < 1e-9);
  BOOST_TEST(reduced_load({ChoiceLoad::Kind::reduced, 0.7}, 30) == 0.7);
}

// Slopes that model.md gives for the small load: 0.010885 and 0.007132 of mode 1 alone; peaks 1..10 carry 0.2
// % of mode 2.
BOOST_AUTO_TEST_CASE(static_releases_measure_what_the_paper_measured) {
  const auto slopes = chain_slopes({0.3, 1}, 2)({{8, 0.01, {5, 12}},
                                                 {10, 0.01, {5, 12}},
                                                 {10, 0.01, {1, 10}},
                                                 {10, 0.05, {0, 4}},
                                                 {10, 2.17, {1, 10}}});
  BOOST_TEST(std::abs(slopes[0] / 0.010885 - 1) < 2e-4);
  BOOST_TEST(std::abs(slopes[1] / 0.007132 - 1) < 2e-4);
  BOOST_TEST(std::abs(slopes[2] / 0.00715 - 1) < 1e-3);
  BOOST_TEST(slopes[3] / slopes[1] > 1.04);  // the point of release among the peaks
  BOOST_TEST(slopes[3] / slopes[1] < 1.1);
  BOOST_TEST(std::abs(slopes[4] / 0.00650 - 1) < 2e-3);
}

BOOST_AUTO_TEST_CASE(releases_side_by_side_are_those_one_by_one) {
  std::vector<StaticReleaseRequest> requests;
  for (const auto& [aspect_ratio, load] : {std::pair{7, 0.3}, {5, 1.1}, {7, 2.0}, {5, 0.01}}) {
    dem::Fiber fiber = nominal_fiber(aspect_ratio, 0.17, dem::BondModel::paper);
    fiber.bond_damping = 0.7;
    requests.push_back({fiber, load, {{1, 4}, {2, aspect_ratio}}});
  }
  const auto together = static_release_damping(requests, 2);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const auto alone = static_release_damping({requests[i]}).front();
    BOOST_REQUIRE(together[i].damping.size() == 2u);
    for (int k : {0, 1}) BOOST_TEST(together[i].damping[k].ratio == alone.damping[k].ratio);
  }
  BOOST_TEST(std::abs(together[3].history.y[0] / (0.01 / 3) - 1) < 0.03);  // over L
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_named) {
  const DampingModel model{DampingLaw::exponential, FitKind::unweighted};
  const auto fitting = [&](std::vector<DampingDatum> points) {
    return message_of<InputError>([&] { fit_damping(model, points); });
  };
  BOOST_TEST(names(fitting({{5, 0.02}, {9, 0.01}}), "3 different aspect ratios or more, 2 given"));
  BOOST_TEST(names(fitting({{5, 0.02}, {5, 0.02}, {9, 0.01}, {9, 0.01}}),
                   "3 different aspect ratios or more, 2 given"));
  BOOST_TEST(names(fitting({{5, 0.02}, {9, -0.01}, {11, 0.01}}), "aspect ratio 9 is not allowed"));
  BOOST_TEST(names(fitting({{5, 0.02}, {9, 0.0}, {11, 0.01}}), "decays"));
  BOOST_TEST(names(fitting({{5, 0.02}, {9, kNan}, {11, 0.01}}), "aspect ratio 9"));
  BOOST_TEST(names(fitting({{0, 0.02}, {9, 0.01}, {11, 0.01}}), "aspect ratio 0"));
  BOOST_TEST(names(message_of<InputError>([&] {
                     fit_damping({DampingLaw::power, FitKind::published}, chain_data({5, 7, 9}));
                   }),
                   "no way to fit"));
  BOOST_TEST(names(message_of<InputError>([&] {
                     damping_fits(chain_data({5, 7, 9, 11}), chain_data({9}), chain_curve(kind, {3, 9}));
                   }),
                   "both fitted and held out"));
  BOOST_TEST(names(message_of<InputError>([] { linear_chain_slope(5, {0.3, -1}); }), "bond damping -1"));
  BOOST_TEST(names(message_of<InputError>([] { linear_chain_slope(5, {0.3, 100}); }), "overdamped"));
}

BOOST_AUTO_TEST_CASE(releases_that_show_no_damping_are_named) {
  dem::Fiber fiber = nominal_fiber(7, 0.17, dem::BondModel::paper);
  const auto releasing = [&](double bond_damping, double load, PeakRange peaks) {
    fiber.bond_damping = bond_damping;
    return message_of<InputError>([&] { static_release_damping({{fiber, load, {peaks}}}); });
  };
  BOOST_TEST(names(releasing(0, 0.1, {1, 4}), "no decay"));
  BOOST_TEST(names(releasing(1, 0, {1, 4}), "load must be above 0"));
  BOOST_TEST(names(releasing(1, kNan, {1, 4}), "load must be above 0"));
  BOOST_TEST(names(releasing(1, 0.1, {4, 4}), "at least two"));
  BOOST_TEST(names(releasing(1, 0.1, {-1, 4}), "first 0 or more"));
  BOOST_TEST(names(releasing(500, 0.1, {1, 4}), "overdamped"));
  fiber.bond_damping = -1;
  BOOST_TEST(names(message_of<dem::InvalidInput>([&] {
                     static_release_damping({{fiber, 0.1, {{1, 4}}}});
                   }),
                   "bond_damping = -1 is not allowed"));
  BOOST_TEST(static_release_damping({}).empty());
}

BOOST_AUTO_TEST_CASE(study_measures_fits_and_tells) {
  FitSweep sweep;
  sweep.aspect_ratio = {5, 7, 8, 9, 11, 13};
  sweep.held_out = {15};
  sweep.poisson_ratio = 0.17;
  const FitStudy study = fit_study(sweep, 2);
  BOOST_TEST(std::abs(find(study.fits, DampingLaw::shifted_square, FitKind::logarithmic).parameters[0] -
                      0.5) < 0.01);
  const dem::Table fits = fit_table(study), residuals = fit_residual_table(study),
                   choices = fit_choice_table(study);
  BOOST_TEST(fits.rows().size() == 8u);
  BOOST_TEST(residuals.rows().size() == 8u * 7);
  BOOST_TEST(choices.rows().size() == study.choices.size());
  for (std::size_t row = 0; row < residuals.rows().size(); ++row) {
    const double slope = residuals.number(row, "damping_slope"),
                 fitted = residuals.number(row, "damping_slope_fit");
    BOOST_TEST(std::abs(residuals.number(row, "fit_residual") - (fitted / slope - 1)) < 1e-12);
    BOOST_TEST(std::abs(slope / residuals.number(row, "damping_slope_modes") - 1) <
               2e-4);  // the chain marches as it must
    BOOST_TEST((residuals.number(row, "held_out") == 1) == (residuals.number(row, "aspect_ratio") == 15));
  }
  BOOST_TEST(fit_notes(study).find("inference") != std::string::npos);
  BOOST_TEST(fit_notes(study).find("not noise") != std::string::npos);
  BOOST_TEST(fit_figures(study).size() == 3u);
}

BOOST_AUTO_TEST_SUITE_END()
