// The bench: choice of the cheapest, failures that keep their rows, operations counted, references that hold.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "compare/bench/count.hpp"
#include "compare/bench/feature_costs.hpp"
#include "compare/bench/history_reference.hpp"
#include "compare/bench/kernels.hpp"
#include "compare/bench/problems.hpp"
#include "compare/bench/static_reference.hpp"
#include "compare/bench/stiff.hpp"
#include "compare/bench/stiff_packing.hpp"
#include "compare/bench/tables.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/static/case.hpp"
#include "dem/equilibrium/newton.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/leapfrog.hpp"

BOOST_AUTO_TEST_SUITE(bench_test)

namespace compare = fiberchain::compare;
namespace dem = fiberchain::dem;
namespace reference = fiberchain::reference;

using compare::Among;
using compare::Counted;
using compare::OperationCount;
using compare::PrecisionRow;

namespace {

PrecisionRow row(const std::string& method, double error, double seconds) {
  return {.method = method,
          .setting = "s",
          .error = error,
          .time = {seconds, seconds, 1},
          .status = compare::measured_status};
}

const double not_a_number = std::nan("");

}  // namespace

BOOST_AUTO_TEST_CASE(the_cheapest_row_within_the_error_is_chosen) {
  const std::vector<PrecisionRow> rows{row("coarse", 1e-2, 1), row("fine", 1e-3, 3), row("slow", 1e-4, 9),
                                       row("failed", not_a_number, 0.1)};
  BOOST_TEST(compare::cheapest(rows, 2e-2, Among::all)->method == "coarse");
  BOOST_TEST(compare::cheapest(rows, 1e-2, Among::all)->method == "coarse");
  BOOST_TEST(compare::cheapest(rows, 9e-3, Among::all)->method == "fine");
  BOOST_TEST(compare::cheapest(rows, 1e-4, Among::all)->method == "slow");
  BOOST_TEST((compare::cheapest(rows, 9e-5, Among::all) == nullptr));
}

// An error that passes through zero as a method is refined is no merit of that setting.
BOOST_AUTO_TEST_CASE(a_lucky_setting_is_passed_over) {
  const std::vector<PrecisionRow> rows{row("a", 1e-6, 1), row("a", 5e-3, 2), row("a", 1e-4, 4),
                                       row("b", 1e-4, 8)};
  BOOST_TEST(compare::cheapest(rows, 1e-3, Among::all)->time.least == 4.0);
  BOOST_TEST(compare::cheapest(rows, 1e-2, Among::all)->time.least == 1.0);
}

BOOST_AUTO_TEST_CASE(a_choice_can_be_held_to_marching_or_to_the_papers_way) {
  std::vector<PrecisionRow> rows{row("eigenvalue", 1e-9, 0.001), row("implicit", 1e-4, 1),
                                 row("leapfrog", 1e-5, 7)};
  rows[0].in_time = false;
  rows[2].as_paper = true;
  BOOST_TEST(compare::cheapest(rows, 1e-3, Among::all)->method == "eigenvalue");
  BOOST_TEST(compare::cheapest(rows, 1e-3, Among::in_time)->method == "implicit");
  BOOST_TEST(compare::cheapest(rows, 1e-3, Among::as_paper)->method == "leapfrog");
  const compare::PrecisionProblem problem{"p", "", "", "the problem", "", 0, rows};
  const dem::Table table = compare::wanted_table({problem});
  BOOST_TEST(table.rows().size() == 2 * std::size(compare::wanted_errors));
  BOOST_TEST(table.text(1, "method") == "implicit");
  BOOST_TEST(table.number(1, "speedup") == 7.0);
  const std::string text = compare::wanted_markdown({problem});
  BOOST_TEST(text.find("| the problem | eigenvalue, s: 1 ms |") != std::string::npos, text);
  BOOST_TEST(
      text.find("| the problem, marched | implicit, s: 1 s | implicit, s: 1 s | implicit, s: 1 s | – |") !=
          std::string::npos,
      text);
}

BOOST_AUTO_TEST_CASE(what_fails_keeps_its_row_with_the_reason) {
  int runs = 0;
  const auto judge = [](int) -> compare::Judged { return {0.5, {.steps = 3}}; };
  const PrecisionRow good = compare::measured_row(
      {.method = "m", .setting = "s"}, {0.0, 3, 3}, [&] { return ++runs; }, judge);
  BOOST_TEST(good.error == 0.5);
  BOOST_TEST(good.work.steps == 3.0);
  BOOST_TEST(good.time.least > 0.0);
  BOOST_TEST(good.time.least <= good.time.median);
  BOOST_TEST(runs > 3);
  const auto fails = []() -> int { throw std::runtime_error("it diverged"); };
  const PrecisionRow bad = compare::measured_row({.method = "m", .setting = "s"}, {}, fails, judge);
  BOOST_TEST(std::isnan(bad.error));
  BOOST_TEST(bad.status == "it diverged");
  const compare::PrecisionProblem problem{"p", "", "", "", "", 0, {bad}};
  const dem::Table table = compare::precision_table({problem});
  BOOST_TEST(table.rows().size() == 1u);
  BOOST_TEST(table.text(0, "status") == "it diverged");
  BOOST_TEST(compare::precision_notes({problem}).find("m, s: it diverged") != std::string::npos);
  BOOST_TEST(compare::precision_figures({problem}).empty());
}

BOOST_AUTO_TEST_CASE(computations_are_timed_in_turns) {
  std::string order;
  const auto timings = compare::time_in_turns(
      {[&] { order += order.size() < 400 ? "a" : ""; }, [&] { order += order.size() < 400 ? "b" : ""; }},
      {0.0, 5, 5});
  BOOST_TEST(timings.size() == 2u);
  BOOST_TEST(timings[0].runs == 5);
  BOOST_TEST(order.starts_with("aabb"), order);
}

BOOST_AUTO_TEST_CASE(operations_are_counted) {
  OperationCount count;
  const Counted x(3.0, &count), y(4.0, &count), half(0.5);
  const dem::Vec<Counted, 2> v{x, y};
  BOOST_TEST(dem::norm(v).value() == 5.0);
  BOOST_TEST(
      (count == OperationCount{.additions = 1, .multiplications = 2, .fusable = 1, .square_roots = 1}));
  count = {};
  BOOST_TEST((half * half + half).value() == 0.75);  // constants: the compiler's work
  BOOST_TEST((count == OperationCount{}));
  const Counted z = -(half * x) - y / x + sin(x) + cos(x) * atan(y);
  BOOST_TEST(std::abs(z.value() - (-1.5 - 4.0 / 3 + std::sin(3.0) + std::cos(3.0) * std::atan(4.0))) < 1e-15);
  BOOST_TEST((count == OperationCount{.additions = 3,
                                      .multiplications = 2,
                                      .fusable = 2,
                                      .divisions = 1,
                                      .sines = 2,
                                      .arc_tangents = 1}));
}

// Dashpots of a bond in the plane, counted by hand from dem/bond/dashpot.hpp: relative sliding 2 products and
// 2 differences; its component along the bond 2 products, 1 sum, times the difference of two constants; force
// 2 products of each part and 2 sums; bending 1 product.
BOOST_AUTO_TEST_CASE(a_bonds_dashpots_cost_what_their_formula_says) {
  OperationCount count;
  const auto n = [&](double value) { return Counted(value, &count); };
  const dem::BondParameters<Counted> bond{n(1), n(1), n(1), n(1), n(1), n(1), n(0),
                                          n(0), {},   n(4), n(2), n(1), n(3), {}};
  const dem::RelativeMotion<Counted, 2> motion{{n(1), n(2)}, {n(0.5)}, {n(0.25)}};
  const auto action = dem::dashpot_action<Counted, 2>(bond, {n(1), n(0)}, {n(1), n(0)}, motion);
  BOOST_TEST(action.force[0].value() == 4.0);
  BOOST_TEST(action.force[1].value() == 3.0);
  BOOST_TEST(action.moment[0].value() == 0.75);
  BOOST_TEST(count.multiplications == 2.0 + 2 + 1 + 4 + 1);
  BOOST_TEST(count.additions == 2.0 + 1 + 1 + 2);
}

BOOST_AUTO_TEST_CASE(a_bond_step_costs_more_the_more_a_scene_has) {
  const auto flops = [](const dem::Physics& physics) {
    const OperationCount c = compare::operations_of_bond_step(physics);
    BOOST_TEST(c.fusable <= c.additions);
    return c.additions + c.multiplications;
  };
  using dem::BondForm;
  const double plain = flops({2, BondForm::incremental, false, false, false});
  BOOST_TEST(plain > 30.0);
  BOOST_TEST(plain < 200.0);
  BOOST_TEST(flops({2, BondForm::incremental, true, false, false}) > plain);
  BOOST_TEST(flops({2, BondForm::incremental, true, false, false, dem::Solved::dashpots}) >
             flops({2, BondForm::incremental, true, false, false}));
  BOOST_TEST(flops({3, BondForm::incremental, false, false, false}) > 2 * plain);
  BOOST_CHECK_THROW(compare::operations_of_bond_step({3, BondForm::incremental, true, true, true}),
                    dem::InvalidInput);
}

BOOST_AUTO_TEST_CASE(the_bound_is_the_larger_of_what_two_units_must_do) {
  const OperationCount count{.additions = 10,
                             .multiplications = 20,
                             .fusable = 5,
                             .divisions = 2,
                             .square_roots = 1,
                             .sines = 3,
                             .arc_tangents = 1};
  compare::CorePeak peak{
      .fused = false, .multiply_add = 1, .divide = 10, .square_root = 15, .sine = 4, .arc_tangent = 6};
  BOOST_TEST(compare::bound_of(count, peak).arithmetic == 30.0 + 12 + 6);
  BOOST_TEST(compare::bound_of(count, peak).divider == 35.0);
  BOOST_TEST(compare::bound_of(count, peak).least() == 48.0);
  peak.fused = true;
  BOOST_TEST(compare::bound_of(count, peak).arithmetic == 25.0 + 12 + 6);
  peak.divide = 100;
  BOOST_TEST(compare::bound_of(count, peak).least() == 215.0);
}

BOOST_AUTO_TEST_CASE(savings_are_those_of_pairs_that_differ_in_one_thing) {
  const auto best = dem::best_instruction_set();
  using dem::BondForm;
  const std::vector<compare::KernelTime> times{
      {{2, BondForm::incremental, false, false, false}, best, 4, 1e-9, 4e-9},
      {{2, BondForm::incremental, true, false, false}, best, 4, 3e-9, 9e-9},
      {{3, BondForm::incremental, true, false, false}, best, 4, 12e-9, 40e-9},
      {{3, BondForm::total, true, true, false}, best, 4, 50e-9, 90e-9}};
  const auto rows = compare::kernel_feature_costs(times);
  BOOST_REQUIRE(rows.size() == 2u);
  BOOST_TEST(rows[0].skipped == "planar instead of spatial");
  BOOST_TEST(std::abs(rows[0].saving() - 4) < 1e-12);
  BOOST_TEST(rows[1].skipped == "no bond damping");
  BOOST_TEST(std::abs(rows[1].saving() - 3) < 1e-12);
  const dem::Table summary =
      compare::feature_cost_summary({{"s", "", 6, 1}, {"s", "", 4, 2}, {"t", "", 5, 1}, {"s", "", 9, 3}});
  BOOST_TEST(summary.number(0, "saving_least") == 2.0);
  BOOST_TEST(summary.number(0, "saving") == 3.0);
  BOOST_TEST(summary.number(0, "saving_largest") == 6.0);
  BOOST_TEST(summary.number(1, "scenes") == 1.0);
}

BOOST_AUTO_TEST_CASE(root_search_and_newton_find_the_same_equilibrium) {
  const dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, 7};
  const auto chain = dem::straight_chain<2>(fiber);
  const dem::Boundary<2> boundary{{0}, {{7, {0, dem::load_force(fiber, 2.3)}, {}}}};
  const auto solved = dem::solve_equilibrium(chain, boundary).poses.back().position;
  const auto found = compare::equilibrium_by_root_search(chain, boundary, 2.3);
  BOOST_TEST(dem::norm((1 / dem::fiber_length(fiber)) * solved - found.tip) < 1e-12);
  BOOST_TEST(found.error < 1e-12);
}

// At small amplitude the Runge-Kutta path must be the linear chain's first mode.
BOOST_AUTO_TEST_CASE(the_runge_kutta_path_is_the_linear_mode_at_small_amplitude) {
  dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262, 5};
  fiber.bond_damping = 0.7;
  const auto mode = reference::first_bending_mode(compare::linear_chain_of(fiber));
  constexpr double amplitude = 1e-5;
  const auto release = compare::mode_release(fiber, mode, amplitude, 1);
  const std::vector<double> times{0.0, 0.3 * release.period, release.period};
  const auto path = compare::tip_path_by_runge_kutta(release, times, 1e-12);
  for (std::size_t i = 0; i < times.size(); ++i) {
    BOOST_TEST(std::abs(path[i][1] - amplitude * std::exp(mode.eigenvalue * times[i]).real()) <
               1e-8 * amplitude);
  }
}

// Without inertia a fiber in shear is followed to its tolerance; with it the error is the Stokes number's.
BOOST_AUTO_TEST_CASE(the_flow_problem_ranks_methods_by_the_orbit_constant) {
  const compare::PrecisionProblem problem = compare::flow_problem({.quick = true});
  BOOST_REQUIRE_EQUAL(problem.rows.size(), 4u);
  for (const PrecisionRow& measured : problem.rows) BOOST_TEST(measured.status == compare::measured_status);
  BOOST_TEST(problem.reference_error < 1e-5);
  BOOST_TEST(problem.rows[1].error < problem.rows[0].error);
  BOOST_TEST(problem.rows[1].error > 0);
  const double order = std::log10(problem.rows[2].error / problem.rows[3].error);
  BOOST_TEST(std::abs(order - 1) < 0.1);
  BOOST_TEST(problem.rows[3].work.steps >
             3 * problem.rows[2].work.steps);  // steps grow as 1/sqrt(Stokes number)
}

// The scene takes as many times longer as steps are more and dearer.
BOOST_AUTO_TEST_CASE(the_gain_of_solved_bonds_is_that_of_the_step_over_that_of_the_cost) {
  const auto time = [](dem::Integrator integrator, double step, double bonds) {
    return compare::StiffStepTime{
        0.1, "stack", integrator, step, step / 3e-9, 2, bonds, 5, 1, 1e-6, 1e-9 * (bonds + 6) * 1000 / step};
  };
  const dem::Table table = compare::stiff_step_table(
      {time(dem::Integrator::leapfrog, 2e-9, 10), time(dem::Integrator::leapfrog_stiff, 100e-9, 42)});
  BOOST_TEST(table.number(0, "sphere_step_ratio") == 1.0);
  BOOST_TEST(table.number(1, "sphere_step_ns") == 48.0);
  BOOST_TEST(table.number(1, "sphere_step_ratio") == 3.0);
  BOOST_TEST(std::abs(table.number(1, "times_faster") - 50.0 / 3) < 1e-12);
  BOOST_TEST(table.number(1, "coordination") == 4.0);
}

// A release at T/30 and T/90 is off by the scheme's own law, (beta/2 + 1/24)(w dt)^2 of xi_f.
BOOST_AUTO_TEST_CASE(the_rows_of_solved_bonds_follow_the_schemes_error_law) {
  const compare::PrecisionProblem problem =
      compare::damping_problem(10, {.quick = true, .leapfrogs_alone = true});
  const auto error_at = [&](const std::string& setting) {
    for (const PrecisionRow& measured : problem.rows) {
      if (measured.method == "leapfrog-stiff" && measured.setting == setting) return measured.error;
    }
    return not_a_number;
  };
  for (const int steps : {30, 90}) {
    const double angle = 2 * std::numbers::pi / steps,
                 expected = (dem::stiff_beta / 2 + 1.0 / 24) * angle * angle;
    BOOST_TEST(std::abs(error_at("dt = T/" + std::to_string(steps)) / expected - 1) < 0.03);
  }
  const dem::Table times = compare::release_time_table({problem});
  BOOST_TEST(times.rows().size() + 1 == problem.rows.size());  // without the eigenvalue
  BOOST_TEST(times.number(0, "times_faster") == 1.0);
}

// Means of two seeds against the spread of the explicit scheme's, by hand; what failed is left out.
BOOST_AUTO_TEST_CASE(the_effect_of_a_step_is_told_in_spreads_of_the_seeds) {
  const auto run = [](dem::Integrator integrator, double ratio, std::uint64_t seed, double fraction) {
    compare::RestingPacking packing{integrator, ratio, seed};
    packing.solid_fraction = fraction, packing.status = "finished";
    return packing;
  };
  using enum dem::Integrator;
  std::vector<compare::RestingPacking> runs{
      run(leapfrog, 0.7, 1, 0.10), run(leapfrog, 0.7, 2, 0.12), run(leapfrog_stiff, 50, 1, 0.13),
      run(leapfrog_stiff, 50, 2, 0.13), run(leapfrog_stiff, 500, 1, 0.9)};
  runs.back().status = "blew up";
  const dem::Table table = compare::step_effect_table(runs);
  BOOST_TEST(table.text(0, "quantity") == "solid fraction");
  BOOST_TEST(table.text(1, "integrator") == "leapfrog-stiff");
  BOOST_TEST(table.number(1, "step_ratio") == 50.0);
  BOOST_TEST(std::abs(table.number(1, "off_in_spreads") - 0.02 / std::sqrt(2e-4)) < 1e-9);
  BOOST_TEST(table.text(2, "integrator") == "leapfrog");  // the next observable: no row of what blew up
  BOOST_TEST(compare::resting_table(runs).rows().size() == 5u);
}

// Before anything touches, both schemes let the same fibers fall the same way.
BOOST_AUTO_TEST_CASE(a_small_packing_runs_by_both_schemes) {
  const auto runs = compare::resting_packings(
      {.fibers = 8, .seeds = 1, .step_ratios = {25}, .duration = 2e-5}, compare::Jobs(1));
  BOOST_REQUIRE(runs.size() == 2u);
  for (const compare::RestingPacking& run : runs) BOOST_TEST(run.status == "finished");
  BOOST_TEST(runs[0].step_ratio < 1.0);
  BOOST_TEST(std::abs(runs[1].step_ratio - 25) < 1e-9);
  BOOST_TEST(runs[0].solid_fraction > 0.0);
  BOOST_TEST(std::abs(runs[1].solid_fraction / runs[0].solid_fraction - 1) < 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
