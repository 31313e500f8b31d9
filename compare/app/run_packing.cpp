#include "compare/app/run_packing.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "compare/app/results.hpp"
#include "compare/app/stop_signals.hpp"
#include "compare/scenes/packing_report.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/record/csv.hpp"

namespace fiberchain::app {
namespace {

/// A run that is there is neither overwritten nor gone on with unless asked.
void check_directory(const dem::RunFiles& files, const Arguments& arguments) {
  const bool resume = arguments.has("--resume"), force = arguments.has("--force");
  if (resume && force) throw compare::InputError("--resume and --force: give one of them");
  const auto there = dem::files_there(files);
  if (force) dem::remove_files(files);
  if (resume || force || there.empty()) return;
  throw compare::InputError(
      fmt::format("{} is there already, of a run before: --resume goes on with it, --force begins anew",
                  there.front().string()));
}

Results results_of(const dem::PackingJob& job, const dem::PackingEndState& end) {
  Results results{
      .name = job.files.name, .heading = "Packing of fibers", .table = compare::packing_run_table(job, end)};
  const dem::CsvDocument log = dem::read_csv(job.files.log());
  for (auto& [ending, figure] : compare::packing_run_figures(job, log.table)) {
    results.figures.emplace_back(job.files.name + ending, std::move(figure));
  }
  return results;
}

}  // namespace

int run_packing(const dem::SceneText& text, const dem::PackingScene& scene, const Arguments& arguments,
                Context& context) {
  const OutputOptions output = output_options(arguments);
  const std::filesystem::path path = text.name, out = output.out.value_or("results");
  const bool resume = arguments.has("--resume");
  const dem::PackingJob job{text,        scene,  {out, path.stem().string()},
                            output.jobs, resume, context.provenance};
  const auto say = [&](const std::string& words) { context.log->info(words); };
  std::optional<dem::RunBegin> begin;
  if (!resume) begin.emplace(dem::begin_run(job, say));  // what cannot begin leaves nothing behind
  const dem::OutputDirectory directory(out);
  const dem::DirectoryLock lock(out);
  dem::remove_leftovers(job.files);
  check_directory(job.files, arguments);
  if (resume) begin.emplace(dem::begin_run(job, say));
  const StopSignals signals;
  const dem::PackingEndState end = dem::run_packing_session(
      job, std::move(*begin), {[&] { return signals.received() != 0; }, say, context.bar, context.watched});
  if (end.failure.empty() && !end.finished()) {
    context.log->info(
        "stopped at step {} of {}, t = {:.6g} s, with a checkpoint; to go on: fiberchain run {} --out {} "
        "--resume",
        end.last.step, end.steps, end.last.time, path.string(), out.string());
    return kSignaled + signals.received();
  }
  const Results results = results_of(job, end);
  const dem::Table shown = results.table.select({"fibers", "time_step", "step_set_by", "simulated_time",
                                                 "contacts", "height", "bending_mean", "run_time", "status"});
  deliver(results, shown, output, directory, context);
  if (!end.failure.empty()) throw dem::Diverged(end.failure);
  return kSuccess;
}

}  // namespace fiberchain::app
