// The static tables: what the paper says of Figs 3 and 4, the budget, and the orders of both bonds.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "compare/measure/strain.hpp"
#include "compare/static/table.hpp"
#include "compare/static/tip.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "reference/errors.hpp"

BOOST_AUTO_TEST_SUITE(static_test)

using namespace fiberchain;
using compare::StaticCase;
using compare::StaticMethod;
using compare::StaticPoint;
using reference::TipState;

namespace {

StaticPoint point(const StaticCase& asked) { return compare::static_points({asked}).front(); }

double sum(const compare::StaticBudget& b, double TipState::*part) {
  return b.shear.*part + b.stretch.*part + b.discretization.*part + b.history.*part + b.time_step.*part +
         b.leftover_motion.*part;
}

double observed_order(dem::BondModel bond, double StaticPoint::*distance, double load, int coarse, int fine) {
  const double from =
      point({.aspect_ratio = coarse, .poisson_ratio = 0.17, .load = load, .bond = bond}).*distance;
  const double to =
      point({.aspect_ratio = fine, .poisson_ratio = 0.17, .load = load, .bond = bond}).*distance;
  return std::log(from / to) / std::log(static_cast<double>(fine) / coarse);
}

}  // namespace

BOOST_AUTO_TEST_CASE(departures_of_the_papers_figure_4) {
  const dem::Fiber ten = compare::nominal_fiber(10, 0.3, dem::BondModel::paper);
  BOOST_TEST(std::abs(100 * compare::small_load_departure(ten) - 0.2375) < 1e-6);
  BOOST_TEST(std::abs(100 * point({.load = 6}).departure.y - 0.66) < 0.0005);
  // 0.25 % is passed at y/L = 0.171
  BOOST_TEST(100 * point({.load = 0.526}).departure.y < 0.25);
  BOOST_TEST(100 * point({.load = 0.531}).departure.y > 0.25);
  BOOST_TEST(std::abs(point({.load = 0.5283}).tip.y - 0.1712) < 0.0002);
}

BOOST_AUTO_TEST_CASE(parts_of_the_budget_add_up_to_the_departure) {
  for (const auto bond : {dem::BondModel::paper, dem::BondModel::corrected}) {
    for (const auto& [method, form] : {std::pair{StaticMethod::solve, dem::BondForm::total},
                                       std::pair{StaticMethod::march, dem::BondForm::total},
                                       std::pair{StaticMethod::march, dem::BondForm::incremental}}) {
      const StaticPoint p = point({.aspect_ratio = 13,
                                   .poisson_ratio = 0.17,
                                   .load = 2.5,
                                   .bond = bond,
                                   .method = method,
                                   .form = form});
      for (const auto part : {&TipState::y, &TipState::x, &TipState::angle}) {
        BOOST_TEST(std::abs(sum(p.budget, part) - p.departure.*part) < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(parts_of_the_march_are_what_they_are_called) {
  // the total form has no history: what is left after the leftover motion is taken off is the solved state
  const StaticPoint total = point({.aspect_ratio = 13, .load = 2.5, .method = StaticMethod::march});
  BOOST_TEST(std::abs(total.budget.history.y) < 1e-11);
  BOOST_TEST(total.budget.time_step.y == 0);
  // a march stopped early has its leftover motion named, and nothing else changes
  compare::StaticOptions early;
  early.march.residual = 1e-4;
  const StaticPoint stopped =
      compare::static_points({{.aspect_ratio = 13, .load = 2.5, .method = StaticMethod::march}}, early)
          .front();
  BOOST_TEST(std::abs(stopped.budget.leftover_motion.y) > 1e-7);
  BOOST_TEST(std::abs(stopped.budget.leftover_motion.y) < 1e-3);
  // one Newton step names it to its own square
  BOOST_TEST(std::abs(stopped.budget.history.y) < 0.05 * std::abs(stopped.budget.leftover_motion.y));
  // the step's part falls with the square of the step, the history's part stays
  const auto stepped = [](double ratio) {
    compare::StaticOptions options;
    options.march.step_ratio = ratio;
    options.march.residual = 1e-12;
    return compare::static_points({{.aspect_ratio = 10,
                                    .load = 4,
                                    .method = StaticMethod::march,
                                    .form = dem::BondForm::incremental}},
                                  options)
        .front()
        .budget;
  };
  const compare::StaticBudget coarse = stepped(0.4), fine = stepped(0.2);
  const double order = std::log2(coarse.time_step.y / fine.time_step.y);
  BOOST_TEST(order > 1.9);
  BOOST_TEST(order < 2.1);
  BOOST_TEST(coarse.history.y == fine.history.y, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(std::abs(coarse.history.y) > 1e-6);
  BOOST_TEST(std::abs(coarse.history.y) < 1e-5);
}

BOOST_AUTO_TEST_CASE(papers_bond_departs_at_second_order) {
  for (const double load : {0.3, 2.0, 6.0}) {
    const double order = observed_order(dem::BondModel::paper, &StaticPoint::distance, load, 13, 39);
    BOOST_TEST(order > 1.95);
    BOOST_TEST(order < 2.05);
  }
}

BOOST_AUTO_TEST_CASE(corrected_bond_departs_at_fourth_order_apart_from_stretch) {
  for (const double load : {1.0, 3.0, 6.0}) {
    const double order =
        observed_order(dem::BondModel::corrected, &StaticPoint::distance_unstretched, load, 13, 26);
    BOOST_TEST(order > 3.8);
    BOOST_TEST(order < 4.2);
  }
  for (const double load : {0.05, 1.0, 3.0, 4.5, 6.0}) {
    BOOST_TEST(point({.load = load, .bond = dem::BondModel::corrected}).distance_unstretched <= 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(corrected_bond_in_space_is_the_same_chain) {
  const StaticCase planar{
      .aspect_ratio = 13, .poisson_ratio = 0.17, .load = 4, .bond = dem::BondModel::corrected};
  StaticCase spatial = planar;
  spatial.dimension = 3;
  const StaticPoint a = point(planar), b = point(spatial);
  BOOST_TEST(std::abs(a.tip.y - b.tip.y) < 1e-11);
  BOOST_TEST(std::abs(a.tip.x - b.tip.x) < 1e-11);
  BOOST_TEST(std::abs(a.tip.angle - b.tip.angle) < 1e-11);
}

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_the_number_of_threads) {
  compare::StaticSweep sweep;
  sweep.aspect_ratio = {5, 8};
  sweep.load = {0.5, 1, 3};
  sweep.method = {StaticMethod::solve, StaticMethod::march};
  const auto all = compare::cases(sweep);
  const auto one = compare::static_points(all, {.jobs = 1}), two = compare::static_points(all, {.jobs = 2});
  for (std::size_t i = 0; i < all.size(); ++i) {
    BOOST_TEST(one[i].tip.y == two[i].tip.y);
    BOOST_TEST(one[i].steps == two[i].steps);
  }
}

BOOST_AUTO_TEST_CASE(a_case_that_fails_keeps_its_row) {
  compare::StaticOptions options;
  options.march.max_periods = 0.01;
  options.march.residual = 1e-14;
  const auto points =
      compare::static_points({{.load = 1, .method = StaticMethod::march}, {.load = 1}}, options);
  BOOST_TEST(points[0].status != "converged");
  BOOST_TEST(std::isnan(points[0].tip.y));
  BOOST_TEST(points[1].status == "converged");
  const dem::Table table = compare::static_table(points);
  BOOST_TEST(table.rows().size() == 2u);
  BOOST_TEST(std::isnan(table.number(0, "departure_y")));
}

BOOST_AUTO_TEST_CASE(refuses_cases_out_of_range) {
  BOOST_CHECK_THROW(point({.aspect_ratio = 0}), dem::InvalidInput);
  BOOST_CHECK_THROW(point({.poisson_ratio = 0.7}), dem::InvalidInput);
  BOOST_CHECK_THROW(point({.load = -1}), reference::InvalidArgument);
  BOOST_CHECK_THROW(point({.form = dem::BondForm::incremental}), compare::InputError);
  compare::StaticSweep sweep;
  sweep.form = {dem::BondForm::incremental};
  BOOST_CHECK_THROW(compare::cases(sweep), compare::InputError);
}

// The rod's own beam, stretched threefold, is no rod.
BOOST_AUTO_TEST_CASE(a_stretch_beyond_the_rods_linear_law_is_said) {
  const auto points =
      compare::static_points({{.aspect_ratio = 1, .load = 50}, {.aspect_ratio = 6, .load = 6}});
  BOOST_TEST(compare::has_converged(points[0]));
  BOOST_TEST(points[0].status.starts_with("converged, but stretch or shear up to "));
  BOOST_TEST(std::abs(points[0].strain / (2.6 * 50 / 16) - 1) < 1e-9);  // P/(G A) at nu = 0.3
  BOOST_TEST(points[1].status == "converged");
  BOOST_TEST(compare::strain_warning(compare::largest_linear_strain).empty());
  BOOST_TEST(!compare::strain_warning(1.01 * compare::largest_linear_strain).empty());
}

BOOST_AUTO_TEST_SUITE_END()
