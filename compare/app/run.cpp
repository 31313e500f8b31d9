#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/cantilever.hpp"
#include "compare/csv.hpp"

namespace fiberchain::app {
namespace {

Results run_cantilever(const dem::io::CantileverScene& scene, const std::string& name) {
  const compare::CantileverRest rest = compare::rest_of(scene);
  return {.name = name,
          .heading = "Cantilever",
          .table = compare::cantilever_table(scene, rest),
          .more_tables = {{name + "-shape", compare::shape_table(rest)}},
          .figures = {{name + "-shape", compare::shape_figure(scene, rest)}}};
}

int run(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const std::filesystem::path path = arguments.text("SCENE");
  const dem::io::SceneText text = dem::io::read_scene_text(path);
  const dem::io::Scene scene = dem::io::parse_scene(text);
  context.provenance = with_scene(context.provenance, path, text.text);
  const auto directory = open_output(output);
  const std::string name = path.stem().string();
  const Results results = std::visit(
      [&](const dem::io::CantileverScene& cantilever) { return run_cantilever(cantilever, name); }, scene);
  const compare::Table shown =
      results.table.select({"aspect_ratio", "load", "tip_y", "tip_x", "tip_angle", "departure_y",
                            "departure_distance", "residual", "run_time"});
  deliver(results, shown, output, directory, context);
  return kSuccess;
}

}  // namespace

Command run_command() {
  return {.name = "run",
          .description = "run one scene",
          .footer = "Example:\n  fiberchain run data/scenes/cantilever.yaml --out results",
          .options = with_output({{"SCENE", "", "scene file (YAML)", OptionKind::required}}),
          .run = &run};
}

}  // namespace fiberchain::app
