#include <fmt/format.h>
#include <cmath>

#include "compare/bench/problems.hpp"
#include "compare/flow/inertia.hpp"
#include "reference/equivalent_aspect_ratio.hpp"
#include "reference/jeffery.hpp"

namespace fiberchain::compare {
namespace {

constexpr int flow_spheres = 21;
constexpr double number = 300;  // bends by less than 1 % of L

/// The change of C with the time it took, and the work.
struct Drift {
  double change;
  dem::Work work;
};

Drift drift_of(const InertiaCase& asked, double orbits) {
  const double r_e = reference::free_draining_aspect_ratio(asked.spheres);
  const FlowHistory history = run_inertia<3>(asked, orbits * reference::jeffery_period(r_e, 1), 1);
  const auto constant = [&](const FlowMoment& m) { return reference::orbit_constant(r_e, m.direction); };
  return {constant(history.moments.back()) / constant(history.moments.front()) - 1, history.record.work};
}

void times(PrecisionRow& row, double factor) {
  row.time.least *= factor, row.time.median *= factor;
  row.work.steps *= factor, row.work.bond_evaluations *= factor;
  row.work.linear_solves *= factor, row.work.factorizations *= factor;
}

}  // namespace

PrecisionProblem flow_problem(const BenchOptions& options) {
  const double orbits = options.quick ? 3 : 100;
  const InertiaCase still{.spheres = flow_spheres, .elasto_viscous = number, .tolerance = 1e-12};
  InertiaCase looser = still;
  looser.tolerance = 1e-11;
  const double exact = drift_of(still, orbits).change, exact_one = drift_of(still, 1).change;
  PrecisionProblem problem{
      .id = "flow-20",
      .title = fmt::format("{:g} orbits in shear, C = 1, r_f = 20, 3πμ rate {{/:Italic "
                           "L}}^4/{{/:Italic EI}} = {:g}",
                           orbits, number),
      .error_label = "error of the relative change of the orbit constant",
      .short_title = fmt::format("{:g} orbits in shear, r_f = 20, marched", orbits),
      .reference = "the same chain without inertia at 1e-12; own error: its distance from 1e-11",
      .reference_error = std::abs(exact - drift_of(looser, orbits).change),
      .rows = {}};
  for (const double tolerance :
       options.quick ? std::vector{1e-6, 1e-8} : std::vector{1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    const InertiaCase asked{.spheres = flow_spheres, .elasto_viscous = number, .tolerance = tolerance};
    problem.rows.push_back(measured_row(
        {.method = "inertialess",
         .setting = fmt::format("tolerance {:g}", tolerance),
         .aspect_ratio = flow_spheres - 1},
        row_budget(options), [&] { return drift_of(asked, orbits); },
        [&](const Drift& drift) {
          return Judged{std::abs(drift.change - exact), drift.work};
        }));
  }
  // Inertia takes C on in every orbit alike: one is followed, its error and its time stand for all.
  for (const double stokes :
       options.quick ? std::vector{1e-2, 1e-3} : std::vector{1e-2, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5}) {
    const InertiaCase asked{.spheres = flow_spheres,
                            .elasto_viscous = number,
                            .stokes = stokes,
                            .method = dem::FlowMethod::leapfrog};
    PrecisionRow row = measured_row(
        {.method = "leapfrog",
         .setting = fmt::format("Stokes {:g}, one orbit times {:g}", stokes, orbits),
         .aspect_ratio = flow_spheres - 1,
         .as_paper = true},
        row_budget(options), [&] { return drift_of(asked, 1); },
        [&](const Drift& drift) {
          return Judged{orbits * std::abs(drift.change - exact_one), drift.work};
        });
    times(row, orbits);
    problem.rows.push_back(std::move(row));
  }
  return problem;
}

}  // namespace fiberchain::compare
