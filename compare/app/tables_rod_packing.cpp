#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sharded.hpp"
#include "compare/rod_packing/rod_packing.hpp"

namespace fiberchain::app {
namespace {

int run_tables_rod_packing(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  std::vector<int> aspect_ratios{4, 8, 16, 32};
  int fibers = 150, seeds = 3, looks = compare::RodPackingCase{}.looks;
  double friction = 0;
  read_list(arguments, "--aspect-ratio", {.low = 2, .high = 200}, aspect_ratios);
  read_number(arguments, "--friction", {.low = 0, .high = 10}, friction);
  read_number(arguments, "--fibers", {.low = 60, .high = 100000}, fibers);
  read_number(arguments, "--seeds", {.low = 1, .high = 1000}, seeds);
  read_number(arguments, "--looks", {.low = 1, .high = 100000}, looks);
  const auto directory = open_output(output, context);
  auto all =
      compare::rod_packing_cases(aspect_ratios, !arguments.has("--aspect-ratio"), friction, fibers, seeds);
  for (compare::RodPackingCase& c : all) c.looks = looks;
  const std::vector<std::size_t> numbers = deal(all.size(), output, context);
  const auto cases = chosen(all, numbers);
  const auto progress = context.progress(cases.size());
  const auto packings =
      compare::pack_rods(cases, {.jobs = output.jobs, .advance = [&] { progress->advance(); }});
  Results results{.name = "rod-packing",
                  .heading = "Packings of stiff rods",
                  .table = table_by_case(packings, numbers, output, compare::rod_packing_table)};
  const bool any = unfinished(packings) < std::ssize(packings);
  if (!output.shard && any) {
    results.more_tables = {{"rod-packing-kinds", compare::rod_packing_kind_table(packings)}};
    results.figures = {{"rod-packing", compare::rod_packing_figure(packings)}};
  }
  deliver(results, results.more_tables.empty() ? results.table : results.more_tables.front().second, output,
          directory, context);
  return status_of_failed(unfinished(packings), "packings", "", context);
}

}  // namespace

Command tables_rod_packing_command() {
  return {.name = "tables rod-packing",
          .description =
              "stiff rods in a periodic cube that shrinks until they bear a pressure: solid fraction "
              "and contacts by aspect ratio, of smooth rods and of spheres in a row, over seeds",
          .footer = "Example:\n  fiberchain tables rod-packing --aspect-ratio 8 --seeds 2\n",
          .options =
              with_shards({{"--aspect-ratio", "LIST", "of smooth rods [4,8,16,32 and, of both surfaces, 15]"},
                           {"--friction", "MU", "between them [0]"},
                           {"--fibers", "N", "of each packing; 12 r where that is more [150]"},
                           {"--looks", "N", "most of a relaxation, 50 steps each [120]"},
                           {"--seeds", "N", "number of seeds [3]"}}),
          .run = &run_tables_rod_packing};
}

}  // namespace fiberchain::app
