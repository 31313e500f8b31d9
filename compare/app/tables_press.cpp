#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sharded.hpp"
#include "compare/press/press.hpp"

namespace fiberchain::app {
namespace {

int run_tables_press(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  compare::PressCase usual;
  int seeds = 5, samples = 100;
  read_number(arguments, "--fibers", {.low = 20, .high = 100000}, usual.fibers);
  read_number(arguments, "--aspect-ratio", {.low = 4, .high = 200}, usual.aspect_ratio);
  read_number(arguments, "--friction", {.low = 0, .high = 10}, usual.friction);
  read_number(arguments, "--speed", {.low = 1e-3, .high = 10}, usual.speed);
  read_number(arguments, "--seeds", {.low = 1, .high = 1000}, seeds);
  read_number(arguments, "--samples", {.low = 10, .high = 10000}, samples);
  const auto directory = open_output(output, context);
  const std::vector<compare::PressCase> all =
      compare::press_cases(usual.fibers, usual.aspect_ratio, usual.friction, usual.speed, seeds);
  const std::vector<std::size_t> numbers = deal(all.size(), output, context);
  const std::vector<compare::PressCase> cases = chosen(all, numbers);
  const auto progress = context.progress(cases.size());
  const auto runs = compare::run_presses(cases, samples, output.jobs, [&] { progress->advance(); });
  Results results{.name = "press",
                  .heading = "Beds of fibers under a plate",
                  .table = table_by_case(runs, numbers, output, compare::press_table),
                  .notes = compare::press_notes(runs)};
  results.more_tables.emplace_back("press-samples",
                                   table_by_case(runs, numbers, output, compare::press_sample_table));
  if (!output.shard) results.figures.emplace_back("press", compare::press_figure(runs));
  deliver(results, results.table, output, directory, context);
  return status_of_failed(unfinished(runs), "beds", "", context);
}

}  // namespace

Command tables_press_command() {
  return {.name = "tables press",
          .description =
              "a plate presses beds of loose fibers: pressure against solid fraction, and the "
              "exponent of van Wyk's law over seeds",
          .footer = "Example:\n  fiberchain tables press --fibers 50 --seeds 2 --speed 1\n",
          .options = with_shards({{"--fibers", "N", "of each bed, 1 mm thick [100]"},
                                  {"--aspect-ratio", "R", "of the fibers [20]"},
                                  {"--friction", "MU", "between them [0.3]"},
                                  {"--speed", "M/S", "of the plate [0.5]"},
                                  {"--seeds", "N", "number of seeds [5]"},
                                  {"--samples", "N", "intervals of the pressure [100]"}}),
          .run = &run_tables_press};
}

}  // namespace fiberchain::app
