#include "compare/app/run_packing.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "compare/app/results.hpp"
#include "compare/app/stop_signals.hpp"
#include "compare/errors.hpp"
#include "compare/packing/run_report.hpp"
#include "compare/results/csv.hpp"
#include "dem/errors.hpp"

namespace fiberchain::app {
namespace {

/// A run that is there is neither overwritten nor gone on with unless asked.
void check_directory(const compare::RunFiles& files, const Arguments& arguments) {
  const bool resume = arguments.has("--resume"), force = arguments.has("--force");
  if (resume && force) throw compare::InputError("--resume and --force: give one of them");
  const auto there = compare::files_there(files);
  if (force) compare::remove_files(files);
  if (resume || force || there.empty()) return;
  throw compare::InputError(
      fmt::format("{} is there already, of a run before: --resume goes on with it, --force begins anew",
                  there.front().string()));
}

Results results_of(const compare::PackingJob& job, const compare::PackingEndState& end) {
  Results results{
      .name = job.files.name, .heading = "Packing of fibers", .table = packing_run_table(job, end)};
  const compare::CsvDocument log = compare::read_csv(job.files.log());
  for (auto& [ending, figure] : packing_run_figures(job, log.table)) {
    results.figures.emplace_back(job.files.name + ending, std::move(figure));
  }
  return results;
}

}  // namespace

int run_packing(const dem::io::SceneText& text, const dem::io::PackingScene& scene,
                const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  const std::filesystem::path path = text.name, out = output.out.value_or("results");
  const bool resume = arguments.has("--resume");
  const compare::PackingJob job{text,        scene,  {out, path.stem().string()},
                                output.jobs, resume, context.provenance};
  const auto say = [&](const std::string& words) { context.log->info(words); };
  std::optional<compare::RunBegin> begin;
  if (!resume) begin.emplace(compare::begin_run(job, say));  // what cannot begin leaves nothing behind
  const compare::OutputDirectory directory(out);
  const compare::DirectoryLock lock(out);
  compare::remove_leftovers(job.files);
  check_directory(job.files, arguments);
  if (resume) begin.emplace(compare::begin_run(job, say));
  const StopSignals signals;
  const compare::PackingEndState end = compare::run_packing_session(
      job, std::move(*begin), {[&] { return signals.received() != 0; }, say, context.bar, context.watched});
  if (end.failure.empty() && !end.finished()) {
    context.log->info(
        "stopped at step {} of {}, t = {:.6g} s, with a checkpoint; to go on: fiberchain run {} --out {} "
        "--resume",
        end.last.step, end.steps, end.last.time, path.string(), out.string());
    return kSignaled + signals.received();
  }
  const Results results = results_of(job, end);
  const compare::Table shown =
      results.table.select({"fibers", "time_step", "step_set_by", "simulated_time", "contacts", "height",
                            "bending_mean", "run_time", "status"});
  deliver(results, shown, output, directory, context);
  if (!end.failure.empty()) throw dem::Diverged(end.failure);
  return kSuccess;
}

}  // namespace fiberchain::app
