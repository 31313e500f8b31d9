// Rolling friction of the bonds in a ring-down: against the linear mode's own friction, the paper's plateau,
// and itself.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "compare/damping/case.hpp"
#include "compare/friction/law.hpp"
#include "compare/friction/stretch_march.hpp"
#include "compare/friction/table.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"

BOOST_AUTO_TEST_SUITE(friction_test)

using namespace fiberchain;
using compare::RollingCase;
using compare::RollingPoint;
using dem::Rolling;

namespace {

double weak_friction(int aspect_ratio, double nu) {
  const RollingCase asked{.aspect_ratio = aspect_ratio, .poisson_ratio = nu, .bond_damping = 0.01};
  return compare::small_friction_damping(
      compare::rolling_fiber(asked),
      reference::first_bending_mode(compare::linear_chain_of(
          {.aspect_ratio = aspect_ratio, .poisson_ratio = nu, .bond_damping = 0.01})));
}

/// Constant of the endless thin beam: xi_f = constant xi_r (a/L)/r_f, from the clamped-free mode by
/// quadrature.
double beam_constant() {
  constexpr int n = 1000, phases = 1000;
  const double b = 1.87510406871196, sigma = (std::cosh(b) + std::cos(b)) / (std::sinh(b) + std::sin(b));
  const auto slope = [&](double s) {
    return b / 2 * (std::sinh(b * s) + std::sin(b * s) - sigma * (std::cosh(b * s) - std::cos(b * s)));
  };
  const auto curvature = [&](double s) {
    return b * b / 2 * (std::cosh(b * s) + std::cos(b * s) - sigma * (std::sinh(b * s) + std::sin(b * s)));
  };
  const auto shape = [&](double s) {
    return 0.5 * (std::cosh(b * s) - std::cos(b * s) - sigma * (std::sinh(b * s) - std::sin(b * s)));
  };
  std::vector<double> pulled(n + 1, 0.0);  // integral of slope^2 up to s
  for (int i = 0; i < n; ++i) pulled[i + 1] = pulled[i] + std::pow(slope((i + 0.5) / n), 2) / n;
  double sum = 0, across = 0, along = 0;
  for (int i = n - 1; i >= 0; --i) {
    const double s = (i + 0.5) / n;
    across += shape(s) / n;
    along += 0.5 * (pulled[i] + pulled[i + 1]) / n;
    double work = 0;
    for (int k = 0; k < phases; ++k) {
      const double t = std::numbers::pi * (k + 0.5) / phases, c = std::cos(t);
      work += 2 * std::numbers::pi / phases * std::abs(across * slope(s) * c * c - along * std::cos(2 * t)) *
              std::sin(t);
    }
    sum += work * std::abs(curvature(s)) / n;
  }
  return sum / (2 * std::numbers::pi);
}

}  // namespace

BOOST_AUTO_TEST_CASE(weak_friction_of_a_long_chain_is_that_of_the_beam) {
  const double beam = beam_constant();
  BOOST_TEST_MESSAGE("beam " << beam << ", chains " << 50 * weak_friction(50, 0.17) << " "
                             << 200 * weak_friction(200, 0.17));
  BOOST_TEST(std::abs(beam - 0.204) < 5e-4);
  BOOST_TEST(std::abs(200 * weak_friction(200, 0.17) / beam - 1) < 0.004);
  const double coarse = std::abs(50 * weak_friction(50, 0.17) / beam - 1);
  const double fine = std::abs(100 * weak_friction(100, 0.17) / beam - 1);
  BOOST_TEST(coarse / fine > 1.7);
  BOOST_TEST(coarse / fine < 2.4);
}

// The marches' own xi_f without friction is taken off: what is left is the friction's. The linear mode takes
// the fiber as unstretchable; its pull at 2 omega sets the first axial mode swinging by (2
// omega/omega_axial)^2 = 1.25/r_f^2, so the difference falls with r_f; about 1e-3 stays.
BOOST_AUTO_TEST_CASE(weak_friction_adds_what_the_linear_mode_says) {
  for (const int aspect_ratio : {6, 9, 17}) {
    for (const double nu : {-0.1, 0.43}) {
      const auto points = compare::rolling_points(
          {{.aspect_ratio = aspect_ratio, .poisson_ratio = nu, .amplitude = 0.006, .bond_damping = 0.3},
           {.aspect_ratio = aspect_ratio,
            .poisson_ratio = nu,
            .amplitude = 0.006,
            .bond_damping = 0.3,
            .rolling_friction = 2.3}});
      const double ratio = (points[1].damping - points[0].damping) / (points[1].weak - points[1].without);
      BOOST_TEST_MESSAGE("r_f " << aspect_ratio << ", nu " << nu << ": " << ratio);
      BOOST_TEST(ratio > 1);
      BOOST_TEST(ratio < 1 + 1.5e-3 + 0.6 / (aspect_ratio * aspect_ratio));
      BOOST_TEST(std::abs(points[0].damping / points[0].without - 1) < 1e-3);
    }
  }
}

// Twice the amplitude, twice the friction's part; the dashpots' does not change.
BOOST_AUTO_TEST_CASE(friction_damping_is_proportional_to_the_amplitude) {
  const auto points =
      compare::rolling_points({{.aspect_ratio = 13, .amplitude = 0.01, .rolling_friction = 1.7},
                               {.aspect_ratio = 13, .amplitude = 0.02, .rolling_friction = 1.7}});
  const double growth = (points[1].damping - points[1].without) / (points[0].damping - points[0].without);
  BOOST_TEST(growth > 1.93);
  BOOST_TEST(growth < 2.03);
  for (const RollingPoint& p : points) BOOST_TEST(p.first > p.last);
}

BOOST_AUTO_TEST_CASE(the_plateau_is_the_steps) {
  const auto at = [](Rolling law, double friction, double step) {
    return RollingCase{
        .load = 3, .rolling_friction = friction, .law = law, .step_ratio = step, .peaks = {1, 3}};
  };
  const auto p = compare::rolling_points(
      {at(Rolling::set_valued, 2, 0.17), at(Rolling::set_valued, 10, 0.17), at(Rolling::set_valued, 10, 0.1),
       at(Rolling::explicit_sign, 4, 0.1), at(Rolling::explicit_sign, 10, 0.1)});
  BOOST_TEST(p[1].damping / p[0].damping > 3);
  BOOST_TEST(std::abs(p[2].damping / p[1].damping - 1) < 2e-3);
  BOOST_TEST(std::abs(p[4].damping / p[3].damping - 1) < 0.1);
  BOOST_TEST(std::abs(p[3].damping - 0.0014) < 1e-4);
}

BOOST_AUTO_TEST_CASE(without_friction_both_laws_are_the_plain_chain) {
  const auto p = compare::rolling_points(
      {{.aspect_ratio = 9, .load = 0.7}, {.aspect_ratio = 9, .load = 0.7, .law = Rolling::explicit_sign}});
  const auto plain =
      compare::damping_points({{.aspect_ratio = 9, .load = 0.7, .peaks = {1, 5}}}, {.elastica = false});
  for (const RollingPoint& point : p) BOOST_TEST(std::abs(point.damping / plain[0].damping_paper - 1) < 1e-9);
}

BOOST_AUTO_TEST_CASE(summed_stretch_follows_the_length_at_second_order) {
  dem::Fiber fiber = compare::nominal_fiber(7, 0.17, dem::BondModel::paper);
  fiber.bond_damping = 0.7;
  const auto coarse = compare::compare_stretch(fiber, 2.3, 0.16, {1, 4}),
             fine = compare::compare_stretch(fiber, 2.3, 0.08, {1, 4});
  BOOST_TEST(coarse.stretch > 0);
  BOOST_TEST(coarse.stretch < 1e-6);
  BOOST_TEST(std::abs(std::log2(coarse.tip / fine.tip) - 2) < 0.1);
  BOOST_TEST(std::abs(coarse.damping) < 1e-8);
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_the_threads) {
  const auto cases = compare::cases({.aspect_ratio = {5, 9},
                                     .load = {0.7},
                                     .rolling_friction = {0, 3},
                                     .law = {Rolling::set_valued, Rolling::explicit_sign}});
  const auto one = compare::rolling_points(cases, {.jobs = 1}),
             three = compare::rolling_points(cases, {.jobs = 3});
  BOOST_TEST(cases.size() == 8u);
  for (std::size_t i = 0; i < cases.size(); ++i) BOOST_TEST(one[i].damping == three[i].damping);
}

BOOST_AUTO_TEST_CASE(cases_out_of_range_are_refused_and_failures_keep_their_row) {
  BOOST_CHECK_THROW(compare::rolling_points({{.load = 0}}), compare::InputError);
  BOOST_CHECK_THROW(compare::rolling_points({{.amplitude = 0.6}}), compare::InputError);
  BOOST_CHECK_THROW(compare::rolling_points({{.law = Rolling::none}}), compare::InputError);
  BOOST_CHECK_THROW(compare::rolling_points({{.step_ratio = 0.25}}), compare::InputError);
  BOOST_CHECK_THROW(compare::rolling_points({{.peaks = {3, 3}}}), compare::InputError);
  BOOST_CHECK_THROW(compare::rolling_points({{.rolling_friction = -1}}), dem::InvalidInput);
  const auto overdamped = compare::rolling_points({{.aspect_ratio = 3, .bond_damping = 50}});
  BOOST_TEST(std::isnan(overdamped[0].damping));
  BOOST_TEST(overdamped[0].status != "measured");
  BOOST_TEST(compare::rolling_table(overdamped).rows().size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
