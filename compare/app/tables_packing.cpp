#include <algorithm>
#include <filesystem>
#include <optional>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sharded.hpp"
#include "compare/packing/checks.hpp"
#include "compare/packing/pictures.hpp"
#include "compare/packing/study.hpp"

namespace fiberchain::app {
namespace {

using compare::PackingCase;
using compare::PackingRun;

compare::PackingPlan plan_of(const Arguments& arguments) {
  compare::PackingPlan plan;
  read_number(arguments, "--fibers", {.low = 0, .high = 100000}, plan.fibers);
  read_number(arguments, "--seeds", {.low = 0, .high = 100}, plan.seeds);
  read_number(arguments, "--seed-fibers", {.low = 500, .high = 100000}, plan.spread_fibers);
  read_number(arguments, "--duration", {.low = 0, .high = 10, .low_open = true}, plan.duration);
  read_list(arguments, "--bond-damping", {.low = 0}, plan.bond_dampings);
  read_list(arguments, "--friction", {.low = 0, .low_open = true}, plan.rolling_frictions);
  read_list(arguments, "--stiffness", {.low = 1, .low_open = true}, plan.stiffnesses);
  read_number(arguments, "--samples", {.low = 20, .high = 10000}, plan.samples);
  return plan;
}

/// All runs together, so that no thread waits while any is left.
struct Runs {
  std::vector<PackingRun> figures, spread;
  std::vector<std::size_t> numbers;  ///< of these and then those in the whole
};

Runs runs_of(const compare::PackingPlan& plan, const OutputOptions& output, Context& context) {
  std::vector<PackingCase> all_cases = compare::figure_cases(plan);
  const std::size_t figure_cases = all_cases.size();
  std::ranges::copy(compare::spread_cases(plan), std::back_inserter(all_cases));
  Runs runs;
  runs.numbers = deal(all_cases.size(), output, context);
  const std::vector<PackingCase> cases = chosen(all_cases, runs.numbers);
  const auto figures = std::ranges::lower_bound(runs.numbers, figure_cases) - runs.numbers.begin();
  const compare::PackingWatch watch{.samples = plan.samples};
  const auto progress = context.progress(cases.size() * static_cast<std::size_t>(watch.samples + 1));
  std::vector<PackingRun> all =
      compare::run_packings(cases, watch, output.jobs, [&] { progress->advance(); });
  std::ranges::move(all.begin(), all.begin() + figures, std::back_inserter(runs.figures));
  std::ranges::move(all.begin() + figures, all.end(), std::back_inserter(runs.spread));
  return runs;
}

/// What the paper says, judged by the runs of several seeds and the energy of the one that is accounted.
dem::Table statements_of(const Runs& runs, const std::vector<compare::Claim>& claims) {
  std::vector<PackingRun> judged = runs.spread;
  std::ranges::copy_if(runs.figures, std::back_inserter(judged),
                       [](const PackingRun& run) { return run.asked.accounted; });
  return to_table(compare::packing_statements({claims, 1}, judged));
}

/// Read and held against what is measured before the first run.
std::vector<compare::Claim> claims_for(const Arguments& arguments) {
  std::optional<std::filesystem::path> data;
  if (arguments.has("--data")) data = arguments.text("--data");
  auto claims = compare::read_all_published(compare::find_data_directory(data));
  compare::check_complete(claims, "packing", compare::packing_checks());
  return claims;
}

/// Of a shard: run by run, without what needs the runs of all.
Results shard_results(const Runs& runs, const std::vector<PackingRun>& all, const OutputOptions& output) {
  const std::vector<std::size_t> of_figures(runs.numbers.begin(),
                                            runs.numbers.begin() + std::ssize(runs.figures));
  const auto table = [&](const std::vector<PackingRun>& some, const std::vector<std::size_t>& numbers,
                         auto table_of) { return table_by_case(some, numbers, output, table_of); };
  Results results{.name = "packing",
                  .heading = "Packings of flexible fibers, Figs 11 and 12",
                  .table = table(all, runs.numbers, compare::run_table)};
  const auto add = [&](const char* name, dem::Table more) {
    if (!more.rows().empty()) results.more_tables.emplace_back(name, std::move(more));
  };
  add("packing-stages", table(all, runs.numbers, compare::stage_table));
  add("packing-history", table(all, runs.numbers, compare::history_table));
  add("packing-density", table(runs.figures, of_figures, compare::density_table));
  add("packing-orientation", table(runs.figures, of_figures, compare::orientation_table));
  for (std::size_t i = 0; i < runs.figures.size(); ++i) {
    if (runs.figures[i].asked.accounted)
      add("packing-energy", table_of_case(compare::energy_table(runs.figures[i]), runs.numbers[i], output));
  }
  return results;
}

Results results_of(const Runs& runs, const OutputOptions& output) {
  std::vector<PackingRun> all = runs.figures;
  std::ranges::copy(runs.spread, std::back_inserter(all));
  if (output.shard) return shard_results(runs, all, output);
  Results results{.name = "packing",
                  .heading = "Packings of flexible fibers, Figs 11 and 12",
                  .table = compare::run_table(all),
                  .notes = compare::packing_notes(runs.figures, runs.spread)};
  const auto add = [&](const char* name, dem::Table table) {
    if (!table.rows().empty()) results.more_tables.emplace_back(name, std::move(table));
  };
  add("packing-stages", compare::stage_table(all));
  add("packing-spread", compare::spread_table(runs.spread));
  add("packing-differences", compare::comparison_table(runs.spread));
  add("packing-history", compare::history_table(all));
  add("packing-density", compare::density_table(runs.figures));
  add("packing-orientation", compare::orientation_table(runs.figures));
  for (const PackingRun& run : runs.figures) {
    if (run.asked.accounted) add("packing-energy", compare::energy_table(run));
  }
  results.figures = compare::packing_figures(runs.figures, runs.spread);
  return results;
}

int status_of(const Runs& runs, const Context& context) {
  return status_of_failed(unfinished(runs.figures) + unfinished(runs.spread), "packings", "", context);
}

/// Runs whose places were kept, which are many: those of the others stay without.
std::vector<PackingRun> with_pictures(Runs& runs) {
  std::vector<PackingRun> pictured;
  for (PackingRun& run : runs.figures) {
    if (run.pictures.empty()) continue;
    pictured.push_back(run);
    run.pictures.clear();
  }
  return pictured;
}

int run_tables_packing(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const compare::PackingPlan plan = plan_of(arguments);
  const std::vector<compare::Claim> claims =
      plan.seeds > 0 ? claims_for(arguments) : std::vector<compare::Claim>();
  const auto directory = open_output(output, context);
  Runs runs = runs_of(plan, output, context);
  const std::vector<PackingRun> pictured = output.shard ? std::vector<PackingRun>() : with_pictures(runs);
  Results results = results_of(runs, output);
  for (const PackingRun& run : pictured) {
    results.pictures.emplace_back(
        [&] { return compare::stage_pictures(run, output.jobs, context.provenance); });
  }
  if (!runs.spread.empty() && !output.shard)
    results.more_tables.emplace_back("packing-statements", statements_of(runs, claims));
  const dem::Table shown = results.table.select(
      {"bond_damping", "rolling_friction", "stiffness", "fibers", "seed", "step_factor", "bending_peak",
       "bending_trough", "bending_plateau", "height", "solid_fraction", "coordination", "run_time"});
  deliver(results, shown, output, directory, context);
  return status_of(runs, context);
}

}  // namespace

Command tables_packing_command() {
  return {.name = "tables packing",
          .description =
              "2000 fibers fall and pack: stages (Fig 11), bending against time (Fig 12), densities, energy",
          .footer = std::string("The packings of one seed are run with --fibers, those of several seeds with "
                                "--seed-fibers on a\n"
                                "smaller floor with periodic sides, as deep.\n"
                                "With --fibers 0 --seeds 5 there are spreads alone, of five seeds.\n"
                                "Shards (--shard) have the tables of single runs: spreads, differences and "
                                "statements need all.\n"
                                "Example:\n  fiberchain tables packing --fibers 500 --seeds 0 --duration "
                                "0.005 --samples 20\n") +
                    kListHelp,
          .options = with_shards(
              {{"--fibers", "N", "of each packing of the first seed; 0: none of them [2000]"},
               {"--seeds", "N", "number of seeds for the spread; 0: none [3]"},
               {"--seed-fibers", "N", "of each packing of these [500]"},
               {"--bond-damping", "LIST", "xi_b without rolling friction [0.1,1,5]"},
               {"--friction", "LIST", "xi_r, at the first xi_b [1,2]"},
               {"--stiffness", "LIST", "factors to Young's modulus, at the first xi_b [20]"},
               {"--data", "DIR", "data directory, in place of FIBERCHAIN_DATA or the program's own"},
               {"--duration", "SECONDS", "simulated [0.6]"},
               {"--samples", "N", "intervals of the histories [140]"}}),
          .run = &run_tables_packing};
}

}  // namespace fiberchain::app
