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
  std::vector<compare::PressCase> all =
      compare::press_cases(usual.fibers, usual.aspect_ratio, usual.friction, usual.speed, seeds);
  std::vector<int> spacings;
  read_list(arguments, "--smooth", {.low = 1, .high = 50}, spacings);
  if (!spacings.empty()) all = compare::surface_cases(all, spacings);
  const std::vector<std::size_t> numbers = deal(all.size(), output, context);
  const std::vector<compare::PressCase> cases = chosen(all, numbers);
  const auto progress = context.progress(cases.size());
  const auto runs = compare::run_presses(cases, samples, output.jobs, [&] { progress->advance(); });
  Results results{.name = "press",
                  .heading = "Beds of fibers under a plate",
                  .table = table_by_case(runs, numbers, output, compare::press_table),
                  .notes = spacings.empty() ? compare::press_notes(runs) : ""};
  results.more_tables.emplace_back("press-samples",
                                   table_by_case(runs, numbers, output, compare::press_sample_table));
  if (!spacings.empty() && !output.shard && unfinished(runs) < std::ssize(runs))
    results.more_tables.emplace_back("press-surfaces", compare::pressed_surface_table(runs));
  if (!output.shard) results.figures.emplace_back("press", compare::press_figure(runs));
  const bool compared = results.more_tables.back().first == "press-surfaces";
  deliver(results, compared ? results.more_tables.back().second : results.table, output, directory, context);
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
                                  {"--smooth", "LIST",
                                   "compare spheres in a row with smooth fibers of these diameters a bond, "
                                   "from the same start; they divide the aspect ratio [no comparison]"},
                                  {"--seeds", "N", "number of seeds [5]"},
                                  {"--samples", "N", "intervals of the pressure [100]"}}),
          .run = &run_tables_press};
}

}  // namespace fiberchain::app
