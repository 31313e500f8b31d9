#include <fmt/format.h>

#include "compare/app/commands.hpp"
#include "compare/app/options.hpp"
#include "compare/app/results.hpp"
#include "compare/scenes/scene_check.hpp"
#include "compare/study/errors.hpp"
#include "compare/study/json.hpp"
#include "dem/record/columns.hpp"
#include "dem/run/overlaps.hpp"
#include "dem/scene/key_reference.hpp"
#include "dem/scene/located_error.hpp"

namespace fiberchain::app {
namespace {

std::string text_of(const dem::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.4g}", *number);
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *integer);
  return std::get<std::string>(cell);
}

/// A line a column that has a value: name, value and unit.
void print(const dem::Table& table, std::ostream& out) {
  for (const std::string& name : table.columns()) {
    const dem::Cell& cell = table.at(0, name);
    if (std::holds_alternative<dem::Missing>(cell)) continue;
    const std::string_view unit = dem::find_column(name).unit;
    out << fmt::format("{:<16} {}{}{}\n", name, text_of(cell), unit.empty() || unit == "1" ? "" : " ",
                       unit == "1" ? "" : unit);
  }
}

/// The system kills a run that exceeds its memory without a message.
void warn_of_memory(const dem::Table& table, Context& context) {
  const double needed = table.number(0, "memory"), free = table.number(0, "memory_free");
  if (needed > free)
    context.log->warn("warning: the scene needs {:.3g} B of memory, {:.3g} B are free", needed, free);
}

void warn_of_impacts(const dem::Table& table, Context& context) {
  if (std::holds_alternative<dem::Missing>(table.at(0, "impact_overlap"))) return;
  const double overlap = table.number(0, "impact_overlap");
  if (overlap > dem::impact_overlap_limit)
    context.log->warn("{}", dem::expected_impact_in_words(table.number(0, "impact_speed"), overlap));
}

int run_check(const Arguments& arguments, Context& context) {
  if (arguments.has("--keys")) {
    if (arguments.has("SCENE"))
      throw compare::InputError("--keys is not allowed with a scene: it lists the keys of all kinds");
    context.out << dem::key_reference();
    return kSuccess;
  }
  if (!arguments.has("SCENE")) throw compare::InputError("give a scene, or --keys (see --help)");
  const OutputOptions output = output_options(arguments);
  const std::filesystem::path path = arguments.text("SCENE");
  const dem::SceneText text = dem::read_scene_text(path);
  const dem::Scene scene = dem::located(text, [&] { return compare::scene_to_check(text); });
  const dem::Table table = dem::located(text, [&] { return compare::scene_check_table(scene, output.jobs); });
  context.provenance = dem::with_scene(context.provenance, path, text.text);
  warn_of_values(text, context);
  tell_of_meshes(scene, context);
  if (output.json) {
    context.out << dem::to_text(dem::to_json(table, context.provenance));
  } else {
    print(table, context.out);
  }
  warn_of_memory(table, context);
  warn_of_impacts(table, context);
  return kSuccess;
}

}  // namespace

Command check_command() {
  return {.name = "check",
          .description = "read a scene and say what it will take, without running it",
          .footer =
              "Example:\n  fiberchain check data/scenes/packing.yaml\n"
              "Memory of a packing is that of a dense one: 4 pairs and 1.5 contacts a sphere. The cost of a "
              "step is measured\n"
              "for some 50 ms on a dense stack of the scene's fibers; a chain alone has a stated one. No "
              "fiber is inserted:\n"
              "whether they fit, the run tells.",
          .options = {{"SCENE", "", "scene file (YAML)"},
                      json_option(),
                      {"--keys", "", "print all keys of all kinds of scenes, in Markdown", OptionKind::flag},
                      {"--jobs", "N", "threads [all cores]", OptionKind::text, "--threads"}},
          .run = &run_check};
}

}  // namespace fiberchain::app
