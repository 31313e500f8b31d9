#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/bench/problems.hpp"
#include "compare/bench/static_reference.hpp"
#include "compare/static/case.hpp"
#include "dem/equilibrium/newton.hpp"
#include "dem/motion/time_step.hpp"
#include "reference/elastica.hpp"

namespace fiberchain::compare {
namespace {

using dem::BondForm;
using dem::BondModel;
using Point = dem::Vec<double, 2>;
using Distance = std::function<double(const dem::Poses<2>&)>;

constexpr double poisson_ratio = 0.3;
constexpr double rounding = std::numeric_limits<double>::epsilon();

dem::RelaxCase<2> cantilever(int aspect_ratio, BondModel bond, double load) {
  const dem::Fiber fiber = nominal_fiber(aspect_ratio, poisson_ratio, bond);
  dem::Load<2> end{aspect_ratio, {}, {}};
  end.force[1] = dem::load_force(fiber, load);
  return {dem::straight_chain<2>(fiber), {dem::Boundary<2>{{0}, {end}}}};
}

/// |dr| / L of the free end from a point given over L.
Distance distance_from(const Point& point, const dem::Fiber& fiber) {
  const double length = dem::fiber_length(fiber);
  return [=](const dem::Poses<2>& poses) { return dem::norm((1 / length) * poses.back().position - point); };
}

PrecisionRow solved_row(PrecisionRow row, const dem::RelaxCase<2>& job, const Distance& distance,
                        const dem::SolveOptions& solve, const TimingBudget& budget) {
  row.in_time = false;
  row.aspect_ratio = job.chain.fiber.aspect_ratio;
  const auto run = [&] { return dem::solve_equilibrium(job.chain, job.loading[0], solve); };
  return measured_row(row, budget, run, [&](const dem::Equilibrium<2>& found) -> Judged {
    const double n = found.statistics.newton_iterations;
    return {distance(found.poses),
            {.bond_evaluations = n * row.aspect_ratio, .linear_solves = n, .factorizations = n}};
  });
}

PrecisionRow marched_row(PrecisionRow row, const dem::RelaxCase<2>& job, const Distance& distance,
                         const dem::RelaxOptions& march, const TimingBudget& budget) {
  row.aspect_ratio = job.chain.fiber.aspect_ratio;
  const auto run = [&] { return dem::relax_to_equilibrium<2>({job}, march)[0]; };
  return measured_row(row, budget, run, [&](const dem::RelaxResult<2>& found) -> Judged {
    return {distance(found.poses),
            {.steps = found.steps, .bond_evaluations = found.steps * row.aspect_ratio}};
  });
}

/// A march at this part of its own largest stable step.
dem::RelaxOptions at_step(dem::RelaxOptions march, const dem::Fiber& fiber, double part) {
  march.step_ratio.reset();
  march.step_ratio = part / 0.8 * dem::chosen_step(fiber, march) / dem::bond_time_step(fiber);
  return march;
}

struct Bench {
  PrecisionProblem problem;
  const BenchOptions& options;
  TimingBudget budget = row_budget(options);

  void add(PrecisionRow row) { problem.rows.push_back(std::move(row)); }
};

dem::RelaxOptions march_options(BondForm form, double residual) {
  dem::RelaxOptions march;
  march.form = form;
  march.residual = residual;
  return march;
}

/// No drag: the dashpots of the bonds alone bring the chain to rest, xi_b = 1.
dem::RelaxOptions paper_march(double residual) {
  dem::RelaxOptions march = march_options(BondForm::incremental, residual);
  march.bond_damping = 1;
  march.drag = 0;
  return march;
}

std::string name_of(BondForm form) { return fmt::format("march, {}", dem::name(form)); }
constexpr const char* paper_name = "march, bond damping alone (paper)";
TimingBudget long_budget(const TimingBudget& budget) { return {budget.seconds, 2, 3}; }

/// Number of bonds, each bond solved; marched as far as residual 1e-6 is worth.
void add_elastica_rows(Bench& bench, double load, const Point& tip) {
  const bool quick = bench.options.quick;
  const auto distance = [&](const dem::RelaxCase<2>& job) { return distance_from(tip, job.chain.fiber); };
  for (const BondModel bond : {BondModel::paper, BondModel::corrected}) {
    for (const int r_f :
         quick ? std::vector{5, 10, 20, 50} : std::vector{3, 5, 10, 20, 50, 100, 200, 500, 1000}) {
      const auto job = cantilever(r_f, bond, load);
      bench.add(solved_row(
          {.method = fmt::format("solve, {} bond", dem::name(bond)), .setting = fmt::format("r_f = {}", r_f)},
          job, distance(job), {}, bench.budget));
    }
  }
  for (const BondForm form : {BondForm::total, BondForm::incremental}) {
    for (const int r_f : quick ? std::vector{5, 10} : std::vector{3, 5, 10, 20, 60}) {
      const auto job = cantilever(r_f, BondModel::paper, load);
      bench.add(marched_row({.method = name_of(form), .setting = fmt::format("r_f = {}", r_f)}, job,
                            distance(job), march_options(form, 1e-6), bench.budget));
    }
  }
  for (const int r_f : quick ? std::vector{5} : std::vector{3, 5, 10}) {
    const auto job = cantilever(r_f, BondModel::paper, load);
    bench.add(marched_row({.method = paper_name, .setting = fmt::format("r_f = {}", r_f), .as_paper = true},
                          job, distance(job), paper_march(1e-4), long_budget(bench.budget)));
  }
}

/// Tolerance of Newton's method, residual limits of each form, steps of the incremental one, the paper's way.
void add_equilibrium_rows(Bench& bench, const dem::RelaxCase<2>& job, const Distance& distance) {
  const bool quick = bench.options.quick;
  for (const double tolerance : {1e-1, 1e-2, 1e-4, 1e-9}) {
    dem::SolveOptions solve;
    solve.tolerance = tolerance;
    bench.add(solved_row({.method = "solve", .setting = fmt::format("tolerance {:.0e}", tolerance)}, job,
                         distance, solve, bench.budget));
  }
  const auto residual = [](double limit) { return fmt::format("residual {:.0e}", limit); };
  for (const BondForm form : {BondForm::total, BondForm::incremental}) {
    for (const double limit :
         quick ? std::vector{1e-2, 1e-4, 1e-6} : std::vector{1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10}) {
      bench.add(marched_row({.method = name_of(form), .setting = residual(limit)}, job, distance,
                            march_options(form, limit), bench.budget));
    }
  }
  for (const double part : quick ? std::vector{0.95, 0.25} : std::vector{0.95, 0.5, 0.25, 0.125, 0.0625}) {
    bench.add(marched_row(
        {.method = "march, incremental, by step", .setting = fmt::format("dt = {:g} of the limit", part)},
        job, distance, at_step(march_options(BondForm::incremental, 1e-10), job.chain.fiber, part),
        bench.budget));
  }
  for (const double limit : quick ? std::vector{1e-2} : std::vector{1e-2, 1e-4, 1e-6}) {
    bench.add(marched_row({.method = paper_name, .setting = residual(limit), .as_paper = true}, job, distance,
                          paper_march(limit), long_budget(bench.budget)));
  }
}

}  // namespace

TimingBudget row_budget(const BenchOptions& options) {
  return options.quick ? TimingBudget{0.05, 2, 7} : TimingBudget{0.5, 2, 15};
}

PrecisionProblem elastica_problem(double load, const BenchOptions& options) {
  const reference::TipState exact = reference::elastica_closed_form(load),
                            other = reference::elastica_shooting(load);
  Bench bench{{.id = fmt::format("elastica-{:g}", load),
               .title = fmt::format(
                   "Cantilever against the Elastica, {{/:Italic P L}}^2/{{/:Italic EI}} = {:g}", load),
               .error_label = "free end's distance from the Elastica's over {/:Italic L}",
               .short_title = fmt::format("free end against the Elastica, PL²/EI = {:g}", load),
               .reference = "Elastica by elliptic integrals; own error: distance from the shooting solution",
               .reference_error = rounding + std::hypot(exact.y - other.y, exact.x - other.x),
               .rows = {}},
              options};
  add_elastica_rows(bench, load, {1 - exact.x, exact.y});
  return std::move(bench.problem);
}

PrecisionProblem equilibrium_problem(double load, const BenchOptions& options) {
  constexpr int r_f = 10;
  const auto job = cantilever(r_f, BondModel::paper, load);
  const RootSearchTip exact = equilibrium_by_root_search(job.chain, job.loading[0], load);
  Bench bench{
      {.id = fmt::format("equilibrium-{:g}", load),
       .title = fmt::format("Equilibrium of the chain, r_f = {}, {{/:Italic P L}}^2/{{/:Italic EI}} = {:g}",
                            r_f, load),
       .error_label = "free end's distance from equilibrium over {/:Italic L}",
       .short_title = fmt::format("free end of the chain at rest, r_f = {}, PL²/EI = {:g}", r_f, load),
       .reference = "GSL's hybrid root search on the balance of forces; own error: distance of two starts",
       .reference_error = rounding + exact.error,
       .rows = {}},
      options};
  add_equilibrium_rows(bench, job, distance_from(exact.tip, job.chain.fiber));
  return std::move(bench.problem);
}

}  // namespace fiberchain::compare
