#include "compare/app/run_packing.hpp"

#include <fmt/format.h>

#include <exception>
#include <limits>
#include <optional>
#include <utility>

#include "compare/app/results.hpp"
#include "compare/app/stop_signals.hpp"
#include "compare/scenes/packing_report.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/record/csv.hpp"
#include "dem/run/filling_watch.hpp"
#include "dem/run/run_packing.hpp"

namespace fiberchain::app {
namespace {

dem::EarlierRun earlier_run(const Arguments& arguments) {
  const bool resume = arguments.has("--resume"), force = arguments.has("--force");
  if (resume && force) throw compare::InputError("--resume and --force: give one of them");
  if (resume) return dem::EarlierRun::resume;
  return force ? dem::EarlierRun::replace : dem::EarlierRun::refuse;
}

/// " --set KEY=VALUE" for each setting.
std::string typed_settings(const dem::SceneText& text) {
  std::string words;
  for (const dem::SceneSetting& one : text.settings)
    words += fmt::format(" --set '{}={}'", one.key, one.value);
  return words;
}

/// Figures of what the log holds.
std::vector<dem::OutputFile> figures_of(const dem::PackingJob& job, const compare::FigureStyle& style) {
  const dem::CsvDocument log = dem::read_csv(job.files.log());
  std::vector<dem::OutputFile> files;
  for (const auto& [ending, figure] : compare::packing_run_figures(job, log.table)) {
    for (auto& file : compare::figure_files(job.files.name + ending, figure, job.provenance, style))
      files.push_back(std::move(file));
  }
  return files;
}

std::optional<dem::InstructionSet> instruction_set_of(const Arguments& arguments) {
  using dem::InstructionSet;
  std::vector<InstructionSet> sets;
  std::vector<std::pair<std::string, InstructionSet>> words;
  for (const auto set : dem::instruction_sets) words.emplace_back(dem::name(set), set);
  read_choices(arguments, "--instruction-set", sets, words);
  if (sets.empty()) return std::nullopt;
  if (sets.size() > 1) throw compare::InputError("--instruction-set: give one");
  return sets.front();
}

Results results_of(const dem::PackingJob& job, const dem::PackingEndState& end,
                   const compare::FigureStyle& style) {
  Results results{
      .name = job.files.name, .heading = "Packing of fibers", .table = compare::packing_run_table(job, end)};
  if (job.scene.output.samples > 0) results.pictures = {[&job, style] { return figures_of(job, style); }};
  return results;
}

/// What the parts of the run have cost.
std::string cost_in_words(const dem::RunTimes& times) {
  return fmt::format(
      "processor time: march {:.3g} s, samples {:.2g} s, frames {:.2g} s, checkpoints {:.2g} s; output "
      "{:.2g} % "
      "of the march",
      times.march, times.samples, times.frames, times.checkpoints, 100 * times.output() / times.march);
}

/// Run time of a run that had finished before, as its row has it; NaN if that is gone.
double earlier_run_time(const dem::PackingJob& job) {
  try {
    return dem::read_csv(job.files.at(".csv")).table.number(0, "run_time");
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace

int run_packing(const dem::SceneText& text, const dem::PackingScene& scene, const Arguments& arguments,
                Context& context) {
  const OutputOptions output = output_options(arguments);
  const std::filesystem::path path = text.name, out = output.out.value_or("results");
  const dem::EarlierRun earlier = earlier_run(arguments);
  const dem::PackingJob job{.text = text,
                            .scene = scene,
                            .files = {out, path.stem().string()},
                            .threads = output.jobs,
                            .resume = earlier == dem::EarlierRun::resume,
                            .provenance = context.provenance,
                            .instruction_set = instruction_set_of(arguments)};
  const auto say = [&](const std::string& words) { context.log->info(words); };
  if (output.figures && scene.output.samples > 0) warn_without_gnuplot(context);
  const StopSignals signals;
  const auto asked_to_stop = [&] { return signals.received() != 0; };
  std::optional<dem::OpenedRun> opened;
  try {
    opened.emplace(job, earlier, ": --resume goes on with it, --force begins anew", say,
                   dem::filling_watch(asked_to_stop, say, context.bar, context.watched));
  } catch (const dem::Interrupted& stop) {
    context.log->info("{}; nothing is kept of it: a run begins behind its filling", stop.what());
    return kSignaled + signals.received();
  }
  dem::PackingEndState end =
      dem::run_packing_session(job, opened->begin(), {asked_to_stop, say, context.bar, context.watched});
  if (end.failure.empty() && !end.finished()) {
    context.log->info(
        "stopped at step {} of {}, t = {:.6g} s, with a checkpoint{}; to go on: fiberchain run {}{} --out {} "
        "--resume",
        end.last.step, end.steps, end.last.time,
        end.checkpointed == end.last.step ? "" : fmt::format(" of step {}", end.checkpointed), path.string(),
        typed_settings(text), out.string());
    return kSignaled + signals.received();
  }
  if (end.begun_at >= end.steps) end.run_time = earlier_run_time(job);
  if (end.times.march > 0) context.log->info("{}", cost_in_words(end.times));
  const Results results = results_of(job, end, output.style);
  const dem::Table shown = results.table.select({"fibers", "time_step", "step_set_by", "simulated_time",
                                                 "contacts", "height", "bending_mean", "run_time", "status"});
  deliver(results, shown, output, opened->directory(), context);
  if (!end.failure.empty()) throw dem::Diverged(end.failure);
  return kSuccess;
}

}  // namespace fiberchain::app
