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

}  // namespace

int run_scene(const RunOptions& options, Context& context) {
  const dem::io::SceneText text = dem::io::read_scene_text(options.scene);
  const dem::io::Scene scene = dem::io::parse_scene(text);
  context.provenance = with_scene(context.provenance, options.scene, text.text);
  const auto directory = open_output(options.output);
  const std::string name = options.scene.stem().string();
  const Results results = std::visit(
      [&](const dem::io::CantileverScene& cantilever) { return run_cantilever(cantilever, name); }, scene);
  const compare::Table shown =
      results.table.select({"aspect_ratio", "load", "tip_y", "tip_x", "tip_angle", "departure_y",
                            "departure_distance", "residual", "run_time"});
  deliver(results, shown, options.output, directory, context);
  return kSuccess;
}

}  // namespace fiberchain::app
