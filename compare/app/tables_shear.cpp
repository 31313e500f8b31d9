#include <optional>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sharded.hpp"
#include "compare/flow/buckling.hpp"
#include "compare/flow/inertia.hpp"
#include "compare/flow/regimes.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::app {
namespace {

using compare::FlowStudy;
using compare::OrbitOptions;

/// A question, the name of its table, what is shown of it, and what is timed for it, alone.
struct Part {
  const char* name;
  FlowStudy (*study)(const OrbitOptions&);
  std::pair<std::string, dem::Table> (*timing)() = nullptr;
};

FlowStudy periods(const OrbitOptions& options) { return compare::period_study({}, options); }

std::pair<std::string, dem::Table> cost() { return {"shear-cost", compare::flow_cost_table()}; }

constexpr Part kParts[] = {{"period", &periods},
                           {"orbits", &compare::jeffery_study},
                           {"stiffness", &compare::stiffness_study},
                           {"regimes", &compare::regime_study},
                           {"buckling", &compare::buckling_study},
                           {"inertia", &compare::inertia_study, &cost}};

std::vector<Part> parts_of(const Arguments& arguments) {
  std::vector<std::pair<std::string, Part>> choices;
  for (const Part& part : kParts) choices.emplace_back(part.name, part);
  std::vector<Part> chosen{std::begin(kParts), std::end(kParts)};
  read_choices(arguments, "--part", chosen, choices);
  return chosen;
}

/// The sweep of the orbit period that was asked for; nothing if none was.
std::optional<compare::PeriodSweep> tables_shear_sweep(const Arguments& arguments) {
  compare::PeriodSweep sweep{.spheres = {}, .interacting = {}, .stresslets = {}};
  read_list(arguments, "--spheres", {.low = 2, .high = 1000}, sweep.spheres);
  read_list(arguments, "--interacting", {.low = 2, .high = 200}, sweep.interacting);
  read_list(arguments, "--stresslets", {.low = 2, .high = 100}, sweep.stresslets);
  if (sweep.spheres.empty() && sweep.interacting.empty() && sweep.stresslets.empty()) return std::nullopt;
  if (arguments.has("--part")) {
    throw compare::InputError(
        "--part is not allowed with --spheres, --interacting or --stresslets: they are of the period");
  }
  return sweep;
}

/// The chains of these numbers among those of free draining, of interactions and of stresslets, in this
/// order.
compare::PeriodSweep chosen_chains(const compare::PeriodSweep& all, const std::vector<std::size_t>& numbers) {
  compare::PeriodSweep own{.spheres = {}, .interacting = {}, .stresslets = {}};
  for (std::size_t n : numbers) {
    for (auto list : {&compare::PeriodSweep::spheres, &compare::PeriodSweep::interacting,
                      &compare::PeriodSweep::stresslets}) {
      if (n < (all.*list).size()) {
        (own.*list).push_back((all.*list)[n]);
        break;
      }
      n -= (all.*list).size();
    }
  }
  return own;
}

/// A shard's rows with the numbers of their chains.
FlowStudy period_shard(const compare::PeriodSweep& all, const OrbitOptions& options,
                       const OutputOptions& output, Context& context) {
  const std::vector<std::size_t> numbers =
      deal(all.spheres.size() + all.interacting.size() + all.stresslets.size(), output, context);
  FlowStudy study = compare::period_study(chosen_chains(all, numbers), options);
  if (!output.shard) return study;
  study.table = with_cases(study.table, numbers);
  study.figures.clear();
  return study;
}

/// By the name of their tables.
std::vector<std::pair<std::string, FlowStudy>> studies_of(const Arguments& arguments,
                                                          const OrbitOptions& options,
                                                          const OutputOptions& output, Context& context) {
  if (const auto sweep = tables_shear_sweep(arguments))
    return {{"shear", period_shard(*sweep, options, output, context)}};
  const std::vector<Part> all = parts_of(arguments);
  const std::vector<std::size_t> numbers = deal(all.size(), output, context);
  const std::vector<Part> parts = chosen(all, numbers);
  const auto progress = context.progress(parts.size());
  std::vector<std::optional<FlowStudy>> found(parts.size());
  options.jobs.run(parts.size(), [&](std::size_t i) {
    found[i] = parts[i].study(options);
    progress->advance();
  });
  std::vector<std::pair<std::string, FlowStudy>> studies;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    studies.emplace_back(numbers[i] == 0 ? "shear" : std::string("shear-") + parts[i].name,
                         std::move(*found[i]));
    FlowStudy& study = studies.back().second;
    if (parts[i].timing) study.more_tables.push_back(parts[i].timing());
    study.table = table_of_case(study.table, numbers[i], output);
    for (auto& [name, table] : study.more_tables) table = table_of_case(table, numbers[i], output);
  }
  return studies;
}

int run_tables_shear(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const auto directory = open_output(output, context);
  compare::Workers workers(output.jobs);
  auto studies = studies_of(arguments, {.jobs = workers}, output, context);
  Results results{.name = studies.front().first,
                  .heading = "Fibers in shear and extension",
                  .table = studies.front().second.table};
  int failed = 0;
  for (auto& [name, study] : studies) {
    if (name != studies.front().first) results.more_tables.emplace_back(name, std::move(study.table));
    for (auto& more : study.more_tables) results.more_tables.push_back(std::move(more));
    for (auto& figure : study.figures) results.figures.push_back(std::move(figure));
    failed += study.failed;
  }
  deliver(results, results.table, output, directory, context);
  if (failed == 0) return kSuccess;
  context.log->error("error: {} cases could not be measured, see column status", failed);
  return kRunFailed;
}

}  // namespace

Command tables_shear_command() {
  return {.name = "tables shear",
          .description = "fibers in flows: orbit period (Fig 5), orbits, shapes of flexible fibers, buckling",
          .footer = std::string("Without a choice all parts are made.\n"
                                "Example:\n  fiberchain tables shear --spheres 5,11,31 --json\n") +
                    kListHelp,
          .options =
              with_shards({{"--part", "LIST", "period, orbits, stiffness, regimes, buckling, inertia [all]"},
                           {"--spheres", "LIST", "orbit period alone: N = r_f + 1 of free-draining chains"},
                           {"--interacting", "LIST", "N of chains with hydrodynamic interactions"},
                           {"--stresslets", "LIST", "N of chains with interactions and stresslets"}}),
          .run = &run_tables_shear};
}

}  // namespace fiberchain::app
