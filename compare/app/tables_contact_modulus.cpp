#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sharded.hpp"
#include "compare/packing/softening.hpp"
#include "compare/packing/study.hpp"

namespace fiberchain::app {
namespace {

compare::SofteningPlan softening_plan(const Arguments& arguments) {
  compare::SofteningPlan plan;
  read_list(arguments, "--modulus", {.low = 1e-6, .high = 10}, plan.moduli);
  read_number(arguments, "--stiffness", {.low = 0, .high = 1e6, .low_open = true}, plan.stiffness);
  read_number(arguments, "--fibers", {.low = 150, .high = 100000}, plan.fibers);
  read_number(arguments, "--seeds", {.low = 1, .high = 100}, plan.seeds);
  read_number(arguments, "--duration", {.low = 0, .high = 10, .low_open = true}, plan.duration);
  read_number(arguments, "--samples", {.low = 20, .high = 10000}, plan.samples);
  return plan;
}

using TableOf = dem::Table (*)(const std::vector<compare::PackingRun>&);

/// A table of the runs; for a shard modulus by modulus, which are its cases.
dem::Table by_modulus(const std::vector<compare::PackingRun>& runs, const std::vector<double>& moduli,
                      const std::vector<std::size_t>& numbers, const OutputOptions& output,
                      TableOf table_of) {
  if (!output.shard) return table_of(runs);
  std::vector<std::vector<compare::PackingRun>> groups(moduli.size());
  for (const compare::PackingRun& run : runs) {
    const auto group = std::ranges::find(moduli, run.asked.contact_modulus) - moduli.begin();
    groups[static_cast<std::size_t>(group)].push_back(run);
  }
  std::vector<std::size_t> of_rows;
  for (std::size_t i = 0; i < groups.size(); ++i)
    of_rows.insert(of_rows.end(), table_of(groups[i]).rows().size(), numbers[i]);
  return with_cases(table_of(runs), of_rows);
}

int run_tables_contact_modulus(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  compare::SofteningPlan plan = softening_plan(arguments);
  const std::vector<std::size_t> numbers = deal(plan.moduli.size(), output, context);
  plan.moduli = chosen(plan.moduli, numbers);
  const auto directory = open_output(output, context);
  const std::vector<compare::PackingCase> cases = compare::softening_cases(plan);
  const auto progress = context.progress(cases.size() * static_cast<std::size_t>(plan.samples + 1));
  const auto runs =
      compare::run_packings(cases, {.samples = plan.samples}, output.jobs, [&] { progress->advance(); });
  Results results{.name = "contact-modulus",
                  .heading = "Packings by the modulus of their contacts",
                  .table = by_modulus(runs, plan.moduli, numbers, output, compare::softening_table)};
  results.more_tables.emplace_back("contact-modulus-runs",
                                   by_modulus(runs, plan.moduli, numbers, output, compare::run_table));
  if (!output.shard) results.figures.emplace_back("contact-modulus", compare::softening_figure(runs));
  deliver(results, results.table, output, directory, context);
  return status_of_failed(unfinished(runs), "packings", "contact-modulus-runs", context);
}

}  // namespace

Command tables_contact_modulus_command() {
  return {.name = "tables contact-modulus",
          .description =
              "what softened contacts change: packings of stiff fibers by the modulus of their "
              "contacts, with the spread of seeds",
          .footer = std::string("Example:\n  fiberchain tables contact-modulus --fibers 150 --seeds 1 "
                                "--modulus 1,0.01 --duration 0.001 --samples 20\n") +
                    kListHelp,
          .options = with_shards(
              {{"--modulus", "LIST", "of contacts over that of the fibers [1,0.1,0.01,0.001]"},
               {"--stiffness", "FACTOR", "Young's modulus of the fibers over that of tables packing [100]"},
               {"--fibers", "N", "of each packing [300]"},
               {"--seeds", "N", "number of seeds [3]"},
               {"--duration", "SECONDS", "simulated [0.6]"},
               {"--samples", "N", "intervals of the histories [60]"}}),
          .run = &run_tables_contact_modulus};
}

}  // namespace fiberchain::app
