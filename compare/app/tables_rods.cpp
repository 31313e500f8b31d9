#include <fmt/format.h>

#include "compare/app/commands.hpp"
#include "compare/app/measured.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sweep.hpp"
#include "compare/rods/study.hpp"

namespace fiberchain::app {
namespace {

const std::vector<std::string> tables_rods_shown = {
    "rod_benchmark", "bond",      "aspect_ratio", "rod_load",           "rod_value",
    "rod_reference", "rod_error", "rod_order",    "rod_order_expected", "status"};

std::vector<std::string> rod_names() {
  std::vector<std::string> names;
  for (const compare::RodBenchmark& one : compare::rod_benchmarks()) names.emplace_back(one.name);
  return names;
}

SweepOptions<compare::RodSweep> tables_rods_options() {
  using Sweep = compare::RodSweep;
  const Sweep usual;
  std::vector<std::pair<std::string, std::string>> words;
  for (const std::string& name : rod_names()) words.emplace_back(name, name);
  return {words_of("--benchmark", &Sweep::benchmark, words,
                   fmt::format("rods: {} [all]", fmt::join(rod_names(), ", "))),
          list_of("--aspect-ratio", &Sweep::aspect_ratio, {.low = 4, .high = 1000},
                  fmt::format("r_f = L/d, number of bonds; frames leave out odd ones and those that are no "
                              "multiple of 10 [{}]",
                              fmt::join(usual.aspect_ratio, ","))),
          list_of("--poisson-ratio", &Sweep::poisson_ratio, kPoissonRatios,
                  fmt::format("Poisson's ratio [{}]", fmt::join(usual.poisson_ratio, ","))),
          list_of("--load-factor", &Sweep::load_factor, {.low = 0, .high = 10, .low_open = true},
                  fmt::format("of the rod's usual load [{}]", fmt::join(usual.load_factor, ","))),
          words_of("--bond", &Sweep::bond, kBondModels, "bond law: paper, corrected [both]")};
}

int run_tables_rods(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::RodSweep sweep = read_sweep(tables_rods_options(), arguments);
  const auto directory = open_output(output, context);
  const auto [points, numbers] = measured(compare::rod_points, compare::cases(sweep), output, context);
  Results results{.name = "rods",
                  .heading = "Rods in space: chains against the rods they stand for",
                  .table = table_by_case(points, numbers, output, compare::rods_table)};
  if (directory && output.figures && context.stopped == 0 && !output.shard)
    results.figures = compare::rod_figures(output.jobs);
  deliver(results, results.table.select(tables_rods_shown), output, directory, context);
  return status_of_unconverged(points, context);
}

}  // namespace

Command tables_rods_command() {
  return {
      .name = "tables rods",
      .description =
          "rods in space under loads, at their critical loads and beyond: chains against "
          "shooting, with the order in the number of bonds",
      .footer = std::string("Example:\n  fiberchain tables rods --benchmark bend,lees-frame --aspect-ratio "
                            "20 --bond corrected\n") +
                kListHelp,
      .options = with_shards(tables_rods_options()),
      .run = &run_tables_rods};
}

}  // namespace fiberchain::app
