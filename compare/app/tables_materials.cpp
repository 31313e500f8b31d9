#include <optional>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sharded.hpp"
#include "compare/material/study.hpp"

namespace fiberchain::app {
namespace {

using compare::MaterialPart;
using compare::MaterialPlan;

/// A question and what is shown of it.
struct NamedPart {
  const char* name;
  MaterialPart (*make)(const MaterialPlan&, const compare::Jobs&);
};

constexpr NamedPart kMaterialParts[] = {{"modes", &compare::mode_part},
                                        {"two-modes", &compare::two_mode_part},
                                        {"cycle", &compare::cycle_part},
                                        {"wires", &compare::wire_part},
                                        {"packing", &compare::packing_part}};

MaterialPlan material_plan(const Arguments& arguments) {
  MaterialPlan plan;
  read_number(arguments, "--aspect-ratio", {.low = 6, .high = 60}, plan.aspect_ratio);
  read_number(arguments, "--modes", {.low = 1, .high = 5}, plan.modes);
  read_number(arguments, "--diameters", {.low = 2, .high = 1000}, plan.diameters);
  read_number(arguments, "--fibers", {.low = 150, .high = 100000}, plan.packing.fibers);
  read_number(arguments, "--seeds", {.low = 1, .high = 100}, plan.packing.seeds);
  read_number(arguments, "--duration", {.low = 0, .high = 10, .low_open = true}, plan.packing.duration);
  return plan;
}

std::vector<NamedPart> material_parts_of(const Arguments& arguments) {
  std::vector<std::pair<std::string, NamedPart>> choices;
  for (const NamedPart& part : kMaterialParts) choices.emplace_back(part.name, part);
  std::vector<NamedPart> chosen{std::begin(kMaterialParts), std::end(kMaterialParts)};
  read_choices(arguments, "--part", chosen, choices);
  return chosen;
}

int run_tables_materials(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const MaterialPlan plan = material_plan(arguments);
  const std::vector<NamedPart> all = material_parts_of(arguments);
  const std::vector<std::size_t> numbers = deal(all.size(), output, context);
  const auto directory = open_output(output, context);
  const auto progress = context.progress(numbers.size());
  Results results{.name = "materials", .heading = "The damping that materials have"};
  int failed = 0;
  for (const std::size_t n : numbers) {
    MaterialPart made = all[n].make(plan, output.jobs);
    const std::string name = n == 0 ? "materials" : std::string("materials-") + all[n].name;
    if (n == numbers.front()) {
      results.name = name;
      results.table = table_of_case(made.table, n, output);
    } else {
      results.more_tables.emplace_back(name, table_of_case(made.table, n, output));
    }
    for (auto& [more, table] : made.more_tables)
      results.more_tables.emplace_back(more, table_of_case(table, n, output));
    for (auto& figure : made.figures) results.figures.push_back(std::move(figure));
    failed += made.failed;
    progress->advance();
  }
  deliver(results, results.table, output, directory, context);
  return status_of_failed(failed, "packings", "materials-packing", context);
}

}  // namespace

Command tables_materials_command() {
  return {
      .name = "tables materials",
      .description =
          "the damping that materials have: flat loss factors and thermoelastic metals beside "
          "dashpots, by mode, frequency and diameter",
      .footer =
          "Without a choice all parts are made.\n"
          "Example:\n  fiberchain tables materials --part two-modes --json\n",
      .options = with_shards({{"--part", "LIST", "modes, two-modes, cycle, wires, packing [all]"},
                              {"--aspect-ratio", "N", "r_f = L/d of the fibers let go, number of bonds [20]"},
                              {"--modes", "N", "bending modes of each [5]"},
                              {"--diameters", "N", "of the wires, from 1 um to 10 mm [49]"},
                              {"--fibers", "N", "of the packing [300]"},
                              {"--seeds", "N", "of the packing [1]"},
                              {"--duration", "SECONDS", "of the packing [0.4]"}}),
      .run = &run_tables_materials};
}

}  // namespace fiberchain::app
