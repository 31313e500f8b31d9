#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/static_table.hpp"

namespace fiberchain::app {
namespace {

/// The columns worth a look on a terminal; the files have them all.
const std::vector<std::string> kShown = {
    "bond",        "method",  "aspect_ratio", "poisson_ratio",    "load",  "tip_y",
    "departure_y", "shear_y", "stretch_y",    "discretization_y", "status"};

std::vector<compare::StaticPoint> points_of(const TablesStaticOptions& options, const Context& context) {
  const std::vector<compare::StaticCase> cases = compare::cases(options.sweep);
  const auto progress = context.progress(cases.size());
  return static_points(cases, {.jobs = options.output.jobs, .advance = [&] { progress->advance(); }});
}

}  // namespace

int run_tables_static(const TablesStaticOptions& options, Context& context) {
  const auto directory = open_output(options.output);
  const std::vector<compare::StaticPoint> points = points_of(options, context);
  Results results{.name = "static",
                  .heading = "Departure of the chain's free end from the Elastica",
                  .table = compare::static_table(points)};
  if (directory) {
    const compare::Table orders =
        compare::static_order_table(options.sweep.poisson_ratio.front(), options.output.jobs);
    results.more_tables = {{"static-order", orders}};
    results.figures = compare::static_figures(points, orders);
  }
  deliver(results, results.table.select(kShown), options.output, directory, context);
  const auto failed =
      std::ranges::count_if(points, [](const auto& point) { return point.status != "converged"; });
  if (failed == 0) return kSuccess;
  context.log->error("error: {} of {} cases did not converge, see column status", failed, points.size());
  return kRunFailed;
}

}  // namespace fiberchain::app
