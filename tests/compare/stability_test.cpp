// The largest stable step: runs of the chain against the finite chain's modes, the numbers of the model, the
// paper's rules.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/stability/table.hpp"
#include "compare/static/case.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/time_step.hpp"

BOOST_AUTO_TEST_SUITE(stability_test)

using namespace fiberchain;
using compare::StabilityCase;
using compare::StabilityPoint;
using dem::BondModel;
using dem::Integrator;
using reference::ChainEnds;

namespace {

StabilityPoint point(const StabilityCase& asked) { return compare::stability_points({asked}).front(); }

}  // namespace

BOOST_AUTO_TEST_CASE(runs_leave_stability_where_the_modes_do) {
  const auto lagged = compare::cases({.aspect_ratio = {3, 11},
                                      .poisson_ratio = {-0.2, 0.13, 0.25, 0.49},
                                      .bond_damping = {0, 0.07, 1.3, 10},
                                      .scheme = {Integrator::leapfrog},
                                      .ends = {ChainEnds::clamped_free, ChainEnds::free_free}});
  auto all = compare::cases({.aspect_ratio = {6},
                             .poisson_ratio = {-0.2, 0.25, 0.49},
                             .bond_damping = {0.07, 1.3, 10},
                             .scheme = {Integrator::leapfrog_damped}});
  all.insert(all.end(), lagged.begin(), lagged.end());
  for (const StabilityPoint& p : compare::stability_points(all, {.jobs = 2})) {
    BOOST_TEST_CONTEXT(dem::name(p.asked.scheme)
                       << " r_f " << p.asked.aspect_ratio << " nu " << p.asked.poisson_ratio << " xi_b "
                       << p.asked.bond_damping) {
      // half the bracket, and what grows too slowly to be seen
      BOOST_TEST(std::abs(p.difference) < 0.0016);
      BOOST_TEST(p.half_width < 0.00071 * p.measured);
      BOOST_TEST(p.status == "measured");
    }
  }
}

BOOST_AUTO_TEST_CASE(spatial_chains_and_the_total_form_have_the_same_limit) {
  for (const auto form : {dem::BondForm::incremental, dem::BondForm::total}) {
    for (const double xi : {0.0, 0.6}) {
      dem::Fiber fiber = compare::nominal_fiber(7, 0.1, BondModel::paper);
      fiber.bond_damping = xi;
      const compare::StabilityRun run{
          .fiber = fiber, .ends = ChainEnds::free_free, .dimension = 3, .form = form};
      const auto limit = compare::measured_limit(run);
      const double modes = reference::finite_stable_step(compare::linear_chain_of(fiber),
                                                         reference::lagged_dashpots, ChainEnds::free_free);
      BOOST_TEST(limit.stable < modes * 1.001);
      BOOST_TEST(limit.unstable > modes * 0.9999);
      BOOST_TEST(limit.unstable < limit.stable * 1.001401);
      BOOST_TEST(limit.ordered);
    }
  }
}

// What steps_to_grow() counts on.
BOOST_AUTO_TEST_CASE(motions_beyond_the_limit_grow_as_fast_as_runs_are_made_for) {
  for (const auto bond : {BondModel::paper, BondModel::corrected}) {
    for (const double nu : {-0.2, 0.1, 0.25, 0.49}) {
      for (const double xi : {0.0, 0.05, 0.7, 10.0, 300.0}) {
        for (const auto scheme : {Integrator::leapfrog, Integrator::leapfrog_damped}) {
          const StabilityCase asked{
              .aspect_ratio = 17, .poisson_ratio = nu, .bond_damping = xi, .bond = bond, .scheme = scheme};
          const dem::Fiber fiber = compare::stability_fiber(asked);
          const double dt = 1.001 * compare::modal_limit(asked) * dem::bond_time_step(fiber);
          const double growth = reference::growth_per_step(
              compare::linear_chain_of(fiber), compare::time_scheme(scheme), asked.ends, dt, true);
          const double least = scheme == Integrator::leapfrog ? 2 : std::min(2.0, 0.8 / std::max(xi, 1e-9));
          BOOST_TEST((growth - 1) / 0.001 > 0.99 * least,
                     "nu " << nu << " xi_b " << xi << ' ' << dem::name(scheme));
          const compare::StabilityRun run{.fiber = fiber, .scheme = scheme};
          BOOST_TEST(std::pow(growth, compare::steps_to_grow(run, 0.001)) > compare::grown);
        }
      }
    }
  }
}

// A motion must grow or not on either side of the limit, and the criterion must tell 0.2 % apart.
BOOST_AUTO_TEST_CASE(the_criterion_of_growth_is_sharp) {
  for (const double xi : {0.0, 0.01, 0.5, 30.0}) {
    for (const double nu : {-0.15, 0.25, 0.42}) {
      dem::Fiber fiber = compare::nominal_fiber(24, nu, BondModel::corrected);
      fiber.bond_damping = xi;
      const compare::StabilityRun run{.fiber = fiber};
      const double limit = reference::finite_stable_step(compare::linear_chain_of(fiber),
                                                         reference::lagged_dashpots, run.ends, true);
      const int steps = compare::steps_to_grow(run, 1e-3);
      const auto grew = compare::motion_grows(
          run, {0.2 * limit, 0.999 * limit, 0.99999 * limit, 1.001 * limit, 1.5 * limit}, steps);
      BOOST_TEST(grew == (std::vector<bool>{false, false, false, true, true}),
                 boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(limits_at_poisson_s_ratio_0_3) {
  constexpr double damping[] = {0, 0.1, 0.25, 0.5, 1, 2, 5};
  constexpr double limit[] = {1.00, 0.82, 0.60, 0.39, 0.218, 0.113, 0.046};
  for (int i = 0; i < 7; ++i) {
    const StabilityPoint p = point({.aspect_ratio = 30, .bond_damping = damping[i]});
    BOOST_TEST(std::abs(p.endless - limit[i]) < (limit[i] < 0.3 ? 0.0006 : 0.006), p.endless);
    BOOST_TEST(std::abs(p.measured - limit[i]) < (limit[i] < 0.3 ? 0.001 : 0.008), p.measured);
  }
}

BOOST_AUTO_TEST_CASE(the_papers_rules_have_a_verdict_by_run_and_by_theory) {
  const StabilityPoint heavy = point({.bond_damping = 1}), light = point({.bond_damping = 0.5}),
                       none = point({.poisson_ratio = 0.45, .bond_damping = 0});
  BOOST_TEST(heavy.quarter_verdict == "unstable");
  BOOST_TEST(heavy.quarter_growth > 1.2);
  BOOST_TEST(light.quarter_verdict == "stable");
  BOOST_TEST(light.quarter_growth == 1.0);
  BOOST_TEST(light.bond_time_verdict == "unstable");
  BOOST_TEST(none.bond_time_verdict == "stable");  // a finite chain's stiffest mode is a little softer
  BOOST_TEST(none.modes > 1.0);
}

BOOST_AUTO_TEST_CASE(the_step_limit_of_marches_is_the_endless_chains) {
  for (const auto bond : {BondModel::paper, BondModel::corrected}) {
    for (const double nu : {-0.2, 0.245, 0.25, 0.49}) {
      for (const double xi : {0.0, 0.02, 7.0}) {
        const StabilityCase asked{.poisson_ratio = nu, .bond_damping = xi, .bond = bond, .dimension = 3};
        const dem::Fiber fiber = compare::stability_fiber(asked);
        const double own = dem::stable_time_step(fiber) / dem::bond_time_step(fiber);
        // it looks at 65 waves: near nu = 1/4 the strictest may lie between two of them
        BOOST_TEST(own / compare::endless_limit(asked) - 1 > -1e-8, "nu " << nu << " xi_b " << xi);
        BOOST_TEST(own / compare::endless_limit(asked) - 1 < 5e-6, "nu " << nu << " xi_b " << xi);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(threads_change_nothing_and_rows_keep_their_order) {
  const compare::StabilitySweep sweep{
      .aspect_ratio = {4, 9}, .poisson_ratio = {0.1}, .bond_damping = {0.2, 2}};
  const auto one = compare::stability_points(compare::cases(sweep), {.jobs = 1});
  const auto three = compare::stability_points(compare::cases(sweep), {.jobs = 3});
  BOOST_REQUIRE(one.size() == 16);
  BOOST_TEST((compare::stability_table(one).rows() == compare::stability_table(three).rows()));
  BOOST_TEST(one[0].asked.aspect_ratio == 4);
  BOOST_TEST(one[2].asked.aspect_ratio == 9);
}

BOOST_AUTO_TEST_CASE(figures_are_drawn_where_there_are_points_for_them) {
  const compare::StabilitySweep sweep{.aspect_ratio = {4, 6, 9},
                                      .poisson_ratio = {0, 0.3},
                                      .bond_damping = {0, 0.1, 1},
                                      .bond = {BondModel::paper},
                                      .scheme = {Integrator::leapfrog}};
  const auto figures = compare::stability_figures(compare::stability_points(compare::cases(sweep)));
  BOOST_TEST(figures.size() == 7);  // a map and curves each, and one over the aspect ratio
  for (const auto& [name, figure] : figures) {
    const std::string svg = compare::to_svg(figure, {});
    BOOST_TEST(svg.find("</svg>") != std::string::npos, name);
    if (figure.map) BOOST_TEST(svg.find(">0.1<") != std::string::npos, name);
  }
  BOOST_TEST(compare::stability_figures(compare::stability_points({{.aspect_ratio = 4}})).empty());
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  BOOST_CHECK_THROW(point({.scheme = Integrator::implicit}), compare::InputError);
  BOOST_CHECK_THROW(point({.scheme = Integrator::leapfrog_stiff}), compare::InputError);
  BOOST_CHECK_THROW(point({.dimension = 4}), compare::InputError);
  BOOST_CHECK_THROW(point({.bond_damping = -1}), dem::InvalidInput);
  BOOST_CHECK_THROW(point({.aspect_ratio = 0}), dem::InvalidInput);
}

BOOST_AUTO_TEST_SUITE_END()
