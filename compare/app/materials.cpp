#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/calibration/material_table.hpp"

namespace fiberchain::app {
namespace {

int run_materials(const Arguments& arguments, Context& context) {
  OutputOptions output;
  output.json = arguments.has("--json");
  const auto units = std::make_shared<const dem::Units>();
  std::vector<dem::MaterialData> materials;
  for (const std::string& name : dem::material_names())
    materials.push_back(dem::find_material(name, {}, units));
  const Results results{
      .name = "materials", .heading = "Materials", .table = compare::materials_table(materials)};
  deliver(results, results.table, output, std::nullopt, context);
  return kSuccess;
}

}  // namespace

Command materials_command() {
  return {.name = "materials",
          .description = "the materials of data/materials, with where their values are from",
          .footer =
              "Example:\n  fiberchain materials --json\n"
              "Ranges, temperatures and notes of every value are in its file; `from-memory` is checked "
              "against nothing.",
          .options = {json_option()},
          .run = &run_materials};
}

}  // namespace fiberchain::app
