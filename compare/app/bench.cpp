#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/bench/feature_costs.hpp"
#include "compare/bench/mesh.hpp"
#include "compare/bench/packing.hpp"
#include "compare/bench/problems.hpp"
#include "compare/bench/sizes.hpp"
#include "compare/bench/smooth.hpp"
#include "compare/bench/stiff.hpp"
#include "compare/bench/stiff_packing.hpp"
#include "compare/bench/tables.hpp"
#include "compare/bench/threads.hpp"
#include "compare/study/markdown.hpp"
#include "compare/study/published.hpp"
#include "dem/scene/scene.hpp"

namespace fiberchain::app {
namespace {

using compare::BenchOptions;
using compare::PrecisionProblem;

enum class Case {
  statics,
  damping,
  history,
  flow,
  feature_costs,
  kernels,
  packing,
  threads,
  sizes,
  stiff,
  mesh,
  smooth,
  stiff_packing
};
using Cases = std::vector<Case>;

const std::vector<std::string> kShownWanted = {"problem", "wanted_error", "among",    "method",
                                               "setting", "error",        "run_time", "speedup"};
const std::vector<std::string> kShownKernels = {
    "physics",        "instruction_set",     "bond_step_ns",     "bond_step_target_ns", "lone_bond_step_ns",
    "lone_target_ns", "arithmetic_bound_ns", "divider_bound_ns", "bound_fraction"};

bool has(const Cases& cases, Case wanted) { return std::ranges::find(cases, wanted) != cases.end(); }

std::vector<PrecisionProblem> problems_of(const Cases& cases, const BenchOptions& options,
                                          const Context& context) {
  std::vector<PrecisionProblem> problems;
  const auto add = [&](PrecisionProblem problem) {
    context.log->info("measured {}", problem.id);
    problems.push_back(std::move(problem));
  };
  if (has(cases, Case::statics)) {
    for (const double load : options.quick ? std::vector{3.0} : std::vector{0.5, 3.0}) {
      add(compare::elastica_problem(load, options));
      add(compare::equilibrium_problem(load, options));
    }
  }
  if (has(cases, Case::damping)) {
    auto sizes = options.aspect_ratio;
    if (sizes.empty()) sizes = options.quick ? std::vector{10, 30} : std::vector{10, 30, 100};
    for (const int aspect_ratio : sizes) add(compare::damping_problem(aspect_ratio, options));
  }
  if (has(cases, Case::history)) add(compare::history_problem(10, 2, options));
  if (has(cases, Case::flow)) add(compare::flow_problem(options));
  return problems;
}

/// What is printed: the first table as the command's own, the others as notes below it.
struct Report {
  Results results{.name = "bench", .heading = "Run time against error", .table = compare::wanted_table({})};
  std::optional<dem::Table> shown;

  /// `whole` goes to the files, `short_one` to the reader.
  void add(const std::string& name, const std::string& title, const dem::Table& whole,
           const dem::Table& short_one) {
    results.more_tables.emplace_back(name, whole);
    if (shown) {
      results.notes += title + ":\n\n" + dem::to_markdown(short_one) + "\n";
    } else {
      results.table = whole;
      shown = short_one;
    }
  }
};

void add_problems(Report& report, const std::vector<PrecisionProblem>& problems) {
  if (problems.empty()) return;
  const dem::Table wanted = compare::wanted_table(problems);
  report.add("bench-wanted", "", wanted, wanted.select(kShownWanted));
  report.results.more_tables.emplace_back("bench-precision", compare::precision_table(problems));
  report.results.notes += "The same in short, least run time of one chain:\n\n" +
                          compare::wanted_markdown(problems) + "\n" + compare::precision_notes(problems) +
                          "\n";
  report.results.figures = compare::precision_figures(problems);
}

void add_loops(Report& report, const Cases& cases, const BenchOptions& options) {
  if (!has(cases, Case::feature_costs) && !has(cases, Case::kernels)) return;
  const auto times = compare::kernel_times(options);
  if (has(cases, Case::feature_costs)) {
    auto costs = compare::kernel_feature_costs(times);
    for (auto& row : compare::answer_costs(options)) costs.push_back(std::move(row));
    report.add("bench-skips", "What a scene saves, time with over time without",
               compare::feature_cost_table(costs), compare::feature_cost_summary(costs));
  }
  if (has(cases, Case::kernels)) {
    const auto peaks = compare::measured_peaks(times, options);
    const dem::Table shown = compare::kernel_table(compare::widest_or_wanted(times), peaks),
                     peak = compare::peak_table(peaks);
    report.add("bench-kernels", "A bond-step of each inner loop, chains of 11 spheres, and what bounds it",
               compare::kernel_table(times, peaks), shown.select(kShownKernels));
    report.add("bench-peaks", "The core's peak", peak, peak);
    report.results.figures.emplace_back("bench-kernels", compare::kernel_figure(times, peaks));
  }
}

dem::PackingScene ready_scene(const std::string& name) {
  const auto path = compare::find_data_directory(std::nullopt) / "scenes" / (name + ".yaml");
  return std::get<dem::PackingScene>(dem::parse_scene(dem::read_scene_text(path)));
}

void add_packing(Report& report, const dem::PackingScene& scene, const BenchOptions& options) {
  const dem::Table times = compare::packing_time_table(compare::packing_times(scene, options));
  report.add("bench-packing",
             "A sphere-step of a packing, on one thread and two, and of more and fewer spheres", times,
             times);
}

void add_mesh(Report& report, const dem::PackingScene& scene, const BenchOptions& options) {
  const dem::Table times = compare::mesh_time_table(compare::mesh_times(scene, options));
  report.add("bench-mesh", "A sphere-step of a packing in a box of planes and in one of triangles", times,
             times);
}

void add_smooth(Report& report, const dem::PackingScene& scene, const BenchOptions& options) {
  const dem::Table times = compare::smooth_time_table(compare::smooth_times(scene, options));
  report.add("bench-smooth",
             "A step of a packing whose fibers touch by spheres, and by what lies between them", times,
             times);
}

void add_threads(Report& report, const BenchOptions& options) {
  std::vector<compare::NamedScene> scenes;
  for (const char* name : {"crossed-layers", "packing"}) scenes.push_back({name, ready_scene(name)});
  const dem::Table times = compare::thread_table(compare::thread_times(scenes, options));
  report.add("bench-threads", "A step on several threads, measured and by a model of the schedule", times,
             times);
}

void add_sizes(Report& report, const BenchOptions& options) {
  const dem::Table times = compare::sizes_time_table(compare::sizes_times(options));
  report.add("bench-sizes", "A sphere-step of fibers of one size and of many", times, times);
}

void add_stiff(Report& report, const dem::PackingScene& scene, const BenchOptions& options) {
  const auto problems = compare::stiff_release_problems(options);
  const dem::Table releases = compare::release_time_table(problems);
  report.add("bench-stiff-releases", "A period of a release, by the leapfrogs", releases, releases);
  for (auto& figure : compare::precision_figures(problems))
    report.results.figures.push_back(std::move(figure));
  const dem::Table steps = compare::stiff_step_table(compare::stiff_step_times(scene, options));
  report.add(
      "bench-stiff-steps",
      "A sphere-step of 2000 steel fibers with explicit bonds and with bonds solved for, and the time of "
      "the scene at that cost, extrapolated from a slice of it",
      steps, steps);
}

void add_stiff_packing(Report& report, const BenchOptions& options, int jobs) {
  compare::StiffPackingPlan plan;
  if (options.quick) plan.fibers = 12, plan.seeds = 2, plan.duration = 1e-4, plan.step_ratios = {10, 50};
  const auto runs = compare::resting_packings(plan, jobs);
  const dem::Table effects = compare::step_effect_table(runs);
  report.add("bench-stiff-packing", "A small packing of steel fibers at rest, by the step", effects, effects);
  report.results.more_tables.emplace_back("bench-stiff-packing-runs", compare::resting_table(runs));
}

int run_bench(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  Cases cases{Case::statics, Case::damping, Case::history, Case::flow,  Case::feature_costs, Case::kernels,
              Case::packing, Case::threads, Case::sizes,   Case::stiff, Case::mesh,          Case::smooth};
  read_choices<Case>(arguments, "--case", cases,
                     {{"static", Case::statics},
                      {"damping", Case::damping},
                      {"history", Case::history},
                      {"skips", Case::feature_costs},
                      {"kernels", Case::kernels},
                      {"flow", Case::flow},
                      {"packing", Case::packing},
                      {"threads", Case::threads},
                      {"sizes", Case::sizes},
                      {"stiff", Case::stiff},
                      {"mesh", Case::mesh},
                      {"smooth", Case::smooth},
                      {"stiff-packing", Case::stiff_packing}});
  BenchOptions options{.quick = arguments.has("--quick")};
  read_list(arguments, "--aspect-ratio", {.low = 2, .high = 200}, options.aspect_ratio);
  std::optional<dem::PackingScene> packing, steel;  // read now: a bench does not end for want of it
  if (has(cases, Case::packing) || has(cases, Case::mesh) || has(cases, Case::smooth))
    packing = ready_scene("crossed-layers");
  if (has(cases, Case::stiff)) steel = ready_scene("steel-wool");
  const auto directory = open_output(output, context);
  Report report;
  add_problems(report, problems_of(cases, options, context));
  add_loops(report, cases, options);
  if (has(cases, Case::packing)) add_packing(report, *packing, options);
  if (has(cases, Case::threads)) add_threads(report, options);
  if (has(cases, Case::sizes)) add_sizes(report, options);
  if (steel) add_stiff(report, *steel, options);
  if (has(cases, Case::mesh)) add_mesh(report, *packing, options);
  if (has(cases, Case::smooth)) add_smooth(report, *packing, options);
  if (has(cases, Case::stiff_packing)) add_stiff_packing(report, options, output.jobs);
  deliver(report.results, *report.shown, output, directory, context);
  return kSuccess;
}

}  // namespace

Command bench_command() {
  Command command{
      .name = "bench",
      .description =
          "run time against error of every method, what each skip saves, what bounds the inner loops",
      .footer =
          std::string("One thread, but for packings; a method that fails keeps its row with its status.\n"
                      "Example:\n  fiberchain bench --quick --case static\n") +
          kListHelp,
      .options = {{"--quick", "", "fewer settings and runs: a minute in all, not eight", OptionKind::flag},
                  {"--case", "LIST",
                   "static, damping, history, skips, kernels, flow, packing, threads, sizes, stiff, mesh, "
                   "smooth [all of "
                   "these], "
                   "stiff-packing (18 packings in full, half an hour of one core)"},
                  {"--jobs", "N", "packings side by side in stiff-packing [all cores]", OptionKind::text,
                   "--threads"},
                  {"--aspect-ratio", "LIST", "r_f of the damping case [10,30,100; with --quick 10,30]"},
                  json_option(),
                  {"--out", "DIR",
                   "directory for the results; with --json none are written unless given [results]"},
                  no_figures_option()},
      .run = &run_bench};
  for (Option& option : figure_options()) command.options.push_back(std::move(option));
  return command;
}

}  // namespace fiberchain::app
