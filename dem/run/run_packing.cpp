#include "dem/run/run_packing.hpp"

#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <utility>

#include "dem/record/errors.hpp"
#include "dem/record/output.hpp"

namespace fiberchain::dem {
namespace {

PackingJob job_of(const SceneText& text, const PackingScene& scene, const RunOptions& options) {
  const std::filesystem::path path = text.name;
  return {.text = text,
          .scene = scene,
          .files = {options.directory, path.stem().string()},
          .threads = options.threads,
          .resume = options.earlier == EarlierRun::resume,
          .provenance = with_scene(collect_provenance({}), path, text.text)};
}

void check_earlier(const RunFiles& files, EarlierRun earlier) {
  if (earlier == EarlierRun::replace) remove_files(files);
  const auto there =
      earlier == EarlierRun::refuse ? files_there(files) : std::vector<std::filesystem::path>{};
  if (there.empty()) return;
  throw InputError(
      fmt::format("{} is there already, of a run before, which is neither to be resumed nor replaced",
                  there.front().string()));
}

}  // namespace

PackingEndState run_scene(const SceneText& text, const PackingScene& scene, const RunOptions& options) {
  const PackingJob job = job_of(text, scene, options);
  std::optional<RunBegin> begin;
  if (!job.resume) begin.emplace(begin_run(job, options.say));  // a scene that cannot begin leaves no files
  const OutputDirectory directory(options.directory);
  const DirectoryLock lock(options.directory);
  remove_leftovers(job.files);
  check_earlier(job.files, options.earlier);
  if (job.resume) begin.emplace(begin_run(job, options.say));
  return run_packing_session(job, std::move(*begin),
                             {.asked_to_stop = options.asked_to_stop,
                              .say = options.say,
                              .terminal = std::cerr,
                              .watched = false,
                              .sampled = options.sampled});
}

}  // namespace fiberchain::dem
