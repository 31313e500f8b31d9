#include <fmt/format.h>

#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sweep.hpp"
#include "compare/spacing/study.hpp"

namespace fiberchain::app {
namespace {

const std::vector<std::string> tables_spacing_shown = {"bond",
                                                       "aspect_ratio",
                                                       "load",
                                                       "spacing",
                                                       "bonds",
                                                       "departure_distance",
                                                       "frequency_error",
                                                       "stable_step_gain"};

SweepOptions<compare::SpacingSweep> tables_spacing_options() {
  using Sweep = compare::SpacingSweep;
  const Sweep usual;
  return {
      list_of("--aspect-ratio", &Sweep::aspect_ratio, {.low = 2, .high = 1000},
              fmt::format("r_f = L/d [{}]", fmt::join(usual.aspect_ratio, ","))),
      list_of("--spacing", &Sweep::spacing, {.low = 0.05, .high = 500},
              fmt::format("length of a bond over the diameter; those that do not make whole bonds are left "
                          "out [{}]",
                          fmt::join(usual.spacing, ","))),
      list_of("--poisson-ratio", &Sweep::poisson_ratio, kPoissonRatios,
              fmt::format("Poisson's ratio [{}]", fmt::join(usual.poisson_ratio, ","))),
      list_of("--load", &Sweep::load, {.low = 0, .high = 1000, .low_open = true},
              fmt::format("dead load at the free end, P L^2/(E I) [{}]", fmt::join(usual.load, ","))),
      words_of("--bond", &Sweep::bond, kBondModels, "bond law: paper, corrected [both]")};
}

int run_tables_spacing(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::SpacingSweep sweep = read_sweep(tables_spacing_options(), arguments);
  const auto directory = open_output(output, context);
  const auto [points, numbers] = measured(compare::spacing_points, compare::cases(sweep), output, context);
  Results results{.name = "spacing",
                  .heading = "Fibers cut into longer bonds",
                  .table = table_by_case(points, numbers, output, compare::spacing_table)};
  if (directory && context.stopped == 0 && output.makes_fixed_tables())
    results.more_tables = {{"spacing-bonds", compare::fewest_bonds_table(sweep, output.jobs)}};
  if (!output.shard) results.figures = compare::spacing_figures(points);
  deliver(results, results.table.select(tables_spacing_shown), output, directory, context);
  return kSuccess;
}

}  // namespace

Command tables_spacing_command() {
  return {
      .name = "tables spacing",
      .description =
          "fibers cut into bonds longer than thick: free end, first mode, damping, time step; with --out "
          "the fewest bonds for an error, spacing-bonds.csv",
      .footer =
          std::string("Example:\n  fiberchain tables spacing --aspect-ratio 60 --spacing 1,3,5 --load 1\n") +
          kListHelp,
      .options = with_shards(tables_spacing_options()),
      .run = &run_tables_spacing};
}

}  // namespace fiberchain::app
