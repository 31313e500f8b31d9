#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/run_packing.hpp"
#include "compare/app/run_sweep.hpp"
#include "compare/measure/strain.hpp"
#include "compare/scenes/cantilever.hpp"
#include "compare/scenes/damping_report.hpp"
#include "compare/scenes/flow_report.hpp"
#include "compare/scenes/release_report.hpp"
#include "compare/scenes/rod_report.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/record/csv.hpp"
#include "dem/run/memory.hpp"
#include "dem/run/packing_estimate.hpp"
#include "dem/scene/located_error.hpp"
#include "dem/scene/scene_settings.hpp"

namespace fiberchain::app {
namespace {

Results run_cantilever(const dem::CantileverScene& scene, const std::string& name) {
  const compare::CantileverRest rest = compare::rest_of(scene);
  return {.name = name,
          .heading = "Cantilever",
          .table = compare::cantilever_table(scene, rest),
          .more_tables = {{name + "-shape", compare::shape_table(rest)}},
          .figures = {{name + "-shape", compare::shape_figure(scene, rest)}}};
}

Results run_release(const dem::ReleaseScene& scene, const compare::ReleaseRun& run, const std::string& name) {
  return {.name = name,
          .heading = "Release",
          .table = compare::release_table(scene, run),
          .more_tables = {{name + "-history", compare::release_history_table(run)},
                          {name + "-last", compare::release_last_table(run)}},
          .figures = {{name + "-history", compare::release_figure(scene, run)}}};
}

/// What is delivered of a scene, what of it is shown, and why it stopped early, if it did.
struct Outcome {
  Results results;
  dem::Table shown;
  std::string failure;
  std::string warning = "";
};

Outcome outcome_of(const dem::CantileverScene& scene, const std::string& name) {
  Results results = run_cantilever(scene, name);
  dem::Table shown = results.table.select({"aspect_ratio", "load", "tip_y", "tip_x", "tip_angle",
                                           "departure_y", "departure_distance", "residual", "run_time"});
  return {std::move(results), std::move(shown), "", compare::strain_warning(compare::strain_bound(scene))};
}

Outcome outcome_of(const dem::ReleaseScene& scene, const std::string& name) {
  const compare::ReleaseRun run = compare::run_release(scene);
  Results results = run_release(scene, run, name);
  dem::Table shown = results.table.select({"aspect_ratio", "load", "integrator", "step_ratio", "steps",
                                           "fiber_damping", "fiber_damping_modes", "run_time", "status"});
  return {std::move(results), std::move(shown), run.failure,
          compare::strain_warning(compare::strain_bound(scene.fiber, scene.pull.load))};
}

Outcome outcome_of(const dem::FlowScene& scene, const std::string& name) {
  const compare::FlowHistory history = compare::run_flow(scene);
  Results results{.name = name,
                  .heading = "Fiber in a flow",
                  .table = compare::flow_table(scene, history),
                  .more_tables = {{name + "-history", compare::flow_history_table(scene, history)},
                                  {name + "-shapes", compare::flow_shapes_table(scene, history)}}};
  for (auto& [end, figure] : compare::flow_scene_figures(scene, history)) {
    results.figures.emplace_back(name + end, std::move(figure));
  }
  dem::Table shown = results.table.select({"aspect_ratio", "hydrodynamics", "flow_method", "elasto_viscous",
                                           "strain", "period", "orbit_constant", "end_to_end_least",
                                           "bending_angle", "run_time", "status"});
  return {std::move(results), std::move(shown), history.record.failure};
}

Outcome outcome_of(const dem::RodScene& scene, const std::string& name) {
  const compare::RodRun run = compare::run_rod(scene);
  Results results{.name = name,
                  .heading = "Rod",
                  .table = compare::rod_table(scene, run),
                  .more_tables = {{name + "-path", compare::rod_path_table(scene, run)},
                                  {name + "-shapes", compare::rod_shapes_table(scene, run)}},
                  .figures = {{name + "-path", compare::rod_path_figure(scene, run)},
                              {name + "-shapes", compare::rod_shapes_figure(scene, run)}}};
  dem::Table shown = results.table.select({"aspect_ratio", "path_points", "load_factor", "end_x", "end_y",
                                           "end_z", "stability", "limit_points", "first_limit",
                                           "bifurcations", "first_bifurcation", "run_time"});
  return {std::move(results), std::move(shown), ""};
}

/// Of a scene that is one fiber.
Outcome outcome_of(const dem::Scene& scene, const std::string& name) {
  if (const auto* cantilever = std::get_if<dem::CantileverScene>(&scene))
    return outcome_of(*cantilever, name);
  if (const auto* release = std::get_if<dem::ReleaseScene>(&scene)) return outcome_of(*release, name);
  if (const auto* rod = std::get_if<dem::RodScene>(&scene)) return outcome_of(*rod, name);
  return outcome_of(std::get<dem::FlowScene>(scene), name);
}

/// What a scene wanted memory for.
std::string wants_of(const dem::Scene& scene) {
  if (const auto* packing = std::get_if<dem::PackingScene>(&scene)) {
    return fmt::format("{} spheres want about {}", dem::spheres_in(*packing),
                       dem::bytes_in_words(dem::peak(dem::memory_of(*packing))));
  }
  return "the fiber, its samples and its matrices want more than there is";
}

int run_scene(const dem::SceneText& text, const dem::Scene& scene, const Arguments& arguments,
              Context& context) {
  if (const auto* packing = std::get_if<dem::PackingScene>(&scene)) {
    return run_packing(text, *packing, arguments, context);
  }
  for (const char* option : {"--resume", "--force", "--instruction-set"}) {
    if (arguments.has(option))
      throw compare::InputError(std::string(option) + ": is of use only with scene: packing");
  }
  const OutputOptions output = output_options(arguments);
  const std::filesystem::path path = text.name;
  const auto directory = open_output(output, context);
  const Outcome outcome = outcome_of(scene, path.stem().string());
  deliver(outcome.results, outcome.shown, output, directory, context);
  if (!outcome.warning.empty()) context.log->warn("warning: {}", outcome.warning);
  if (!outcome.failure.empty()) throw dem::Diverged(outcome.failure);
  return kSuccess;
}

int run_scene_file(const Arguments& arguments, Context& context) {
  output_options(arguments);
  const std::filesystem::path path = arguments.text("SCENE");
  const dem::SceneText as_read = dem::read_scene_text(path);
  const std::vector<SweptKey> keys = swept_keys(arguments);
  context.provenance = dem::with_scene(context.provenance, path, as_read.text);
  const auto several = [](const SweptKey& key) { return key.values.size() > 1; };
  if (std::ranges::any_of(keys, several)) return run_sweep(as_read, keys, arguments, context);
  if (arguments.has("--shard"))
    throw compare::InputError("--shard: is of use only with several values of --set");
  const dem::SceneText text = with_settings(as_read, combinations(keys).front());
  context.provenance.settings = dem::in_words(text.settings);
  const dem::Scene scene = dem::parse_scene(text);
  warn_of_values(text, context);
  tell_of_meshes(scene, context);
  for (const std::string& line : compare::damping_lines(scene)) context.log->info(line);
  try {
    return dem::located(text, [&] { return run_scene(text, scene, arguments, context); });
  } catch (const std::bad_alloc&) {
    throw std::runtime_error("out of memory: " + wants_of(scene) + dem::memory_in_words());
  }
}

}  // namespace

Command run_command() {
  return {
      .name = "run",
      .description = "run one scene",
      .footer =
          "Example:\n  fiberchain run data/scenes/cantilever.yaml --out results\n"
          "Packings (data/scenes/packing.yaml, packing-small.yaml) write as they go. SIGINT (Ctrl-C) and "
          "SIGTERM\n"
          "stop them at a checkpoint, with status 130 and 143; --resume goes on from there, as after a "
          "crash, and\n"
          "ends in the same state. One run at a time in a directory.\n"
          "With several values, --set contacts.friction=0.2,0.4 --set filling.seed=1..3, every combination "
          "is "
          "run,\n--jobs at a time, each in a directory of its own; NAME-sweep.csv has a row of each. With "
          "--shard every\nmachine of a cluster has its part of them; `fiberchain merge` makes one table.",
      .options = with_shards(
          {{"SCENE", "", "scene file (YAML)", OptionKind::required},
           set_option(),
           {"--resume", "", "packings: go on from the last checkpoint in the directory", OptionKind::flag},
           {"--force", "", "packings: begin anew, in place of a run in the directory", OptionKind::flag},
           {"--instruction-set", "NAME",
            "packings: inner loops of scalar, avx2 or avx512 [a resumed run's own, else the widest "
            "here]"}}),
      .run = &run_scene_file};
}

}  // namespace fiberchain::app
