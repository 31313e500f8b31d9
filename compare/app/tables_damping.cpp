#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/damping_table.hpp"

namespace fiberchain::app {
namespace {

const std::vector<std::string> kShown = {"aspect_ratio",  "bond_damping",        "load",
                                         "fiber_damping", "fiber_damping_paper", "fiber_damping_modes",
                                         "fiber_damping_elastica", "fiber_damping_closed_form", "fiber_damping_eq20",
                                         "status"};

using Points = std::vector<compare::DampingPoint>;
using Cases = std::vector<compare::DampingCase>;

Points measure(const Cases& cases, const TablesDampingOptions& options, const Context& context) {
  const auto progress = context.progress(cases.size());
  return compare::damping_points(cases, {.jobs = options.output.jobs, .advance = [&] { progress->advance(); }});
}

/// All figures' cases measured together, then handed back figure by figure.
compare::DampingFigurePoints measure_figures(const TablesDampingOptions& options, const Context& context, Points& all) {
  const compare::DampingFigureCases wanted = compare::damping_figure_cases(options.sweep.peaks);
  compare::DampingFigurePoints figures;
  Cases cases;
  for (const Cases* part : {&wanted.bond_damping, &wanted.load, &wanted.modulus, &wanted.aspect_ratio}) {
    cases.insert(cases.end(), part->begin(), part->end());
  }
  all = measure(cases, options, context);
  auto next = all.begin();
  const auto take = [&](const Cases& part) {
    const auto first = next;
    next += static_cast<std::ptrdiff_t>(part.size());
    return Points(first, next);
  };
  figures.bond_damping = take(wanted.bond_damping);
  figures.load = take(wanted.load);
  figures.modulus = take(wanted.modulus);
  figures.aspect_ratio = take(wanted.aspect_ratio);
  return figures;
}

}  // namespace

int run_tables_damping(const TablesDampingOptions& options, Context& context) {
  const auto directory = open_output(options.output);
  Points points;
  Results results{.name = "damping", .heading = "Damping of the fiber by dashpots in its bonds",
                  .table = compare::damping_table({})};
  if (options.chosen) {
    points = measure(compare::cases(options.sweep), options, context);
  } else {
    const compare::DampingFigurePoints figures = measure_figures(options, context, points);
    const compare::Table ring_down = compare::ring_down_table({.load = 1.0}, 12);
    results.more_tables = {{"fig-6", ring_down}, {"damping-dashpots", compare::dashpot_table(10, 0.3)}};
    results.figures = compare::damping_figures(figures, ring_down);
  }
  results.table = compare::damping_table(points);
  deliver(results, results.table.select(kShown), options.output, directory, context);
  const auto failed = std::ranges::count_if(points, [](const auto& point) { return point.status != "measured"; });
  if (failed == 0) return kSuccess;
  context.log->error("error: {} of {} cases could not be measured, see column status", failed, points.size());
  return kRunFailed;
}

}  // namespace fiberchain::app
