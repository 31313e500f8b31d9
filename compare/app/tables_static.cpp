#include <fmt/format.h>

#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sweep.hpp"
#include "compare/measure/strain.hpp"
#include "compare/static/table.hpp"

namespace fiberchain::app {
namespace {

/// The columns worth a look on a terminal; the files have them all.
const std::vector<std::string> tables_static_shown = {
    "bond",        "method",  "aspect_ratio", "poisson_ratio",    "load",  "tip_y",
    "departure_y", "shear_y", "stretch_y",    "discretization_y", "status"};

SweepOptions<compare::StaticSweep> tables_static_options() {
  using Sweep = compare::StaticSweep;
  using compare::StaticMethod;
  const Sweep usual;
  return {
      list_of("--aspect-ratio", &Sweep::aspect_ratio, {.low = 1, .high = 1e5},
              fmt::format("r_f = L/d, number of bonds [{}]", fmt::join(usual.aspect_ratio, ","))),
      list_of("--poisson-ratio", &Sweep::poisson_ratio, kPoissonRatios,
              fmt::format("Poisson's ratio [{}]", fmt::join(usual.poisson_ratio, ","))),
      list_of("--load", &Sweep::load, {.low = 0, .high = 1000, .low_open = true},
              fmt::format("dead load at the free end, P L^2/(E I) [{}]", fmt::join(usual.load, ","))),
      words_of("--bond", &Sweep::bond, kBondModels, "bond law: paper, corrected [paper]"),
      words_of("--method", &Sweep::method, {{"solve", StaticMethod::solve}, {"march", StaticMethod::march}},
               "way to the equilibrium: solve, march [solve]"),
      words_of("--form", &Sweep::form, kBondForms,
               "form of the bond law: total, incremental (march only) [total]"),
      words_of("--dimension", &Sweep::dimension, kDimensions, "planar, spatial [planar]")};
}

int run_tables_static(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::StaticSweep sweep = read_sweep(tables_static_options(), arguments);
  const auto directory = open_output(output, context);
  const auto [points, numbers] = measured(compare::static_points, compare::cases(sweep), output, context);
  Results results{.name = "static",
                  .heading = "Departure of the chain's free end from the Elastica",
                  .table = table_by_case(points, numbers, output, compare::static_table)};
  if (directory && context.stopped == 0 && output.makes_fixed_tables()) {
    const dem::Table orders = compare::static_order_table(sweep.poisson_ratio.front(), output.jobs);
    results.more_tables = {{"static-order", orders}};
    if (!output.shard) results.figures = compare::static_figures(points, orders);
  }
  deliver(results, results.table.select(tables_static_shown), output, directory, context);
  const auto warned = std::ranges::count_if(
      points, [](const auto& point) { return point.strain > compare::largest_linear_strain; });
  if (warned > 0) {
    context.log->warn(
        "warning: {} of {} cases stretch or shear beyond {}, where a rod's linear laws end: see "
        "columns largest_strain and status",
        warned, points.size(), compare::largest_linear_strain);
  }
  return status_of_unconverged(points, context);
}

}  // namespace

Command tables_static_command() {
  return {
      .name = "tables static",
      .description = "departure of the chain from the Elastica and its causes (Figs 3, 4)",
      .footer = std::string("Example:\n  fiberchain tables static --aspect-ratio 10,13 --poisson-ratio 0.17 "
                            "--load 0.5,6 --json\n") +
                kListHelp,
      .options = with_shards(tables_static_options()),
      .run = &run_tables_static};
}

}  // namespace fiberchain::app
