#include "dem/run/run_packing.hpp"

#include <fmt/format.h>

#include <iostream>

#include "dem/record/errors.hpp"
#include "dem/run/filling_watch.hpp"

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

}  // namespace

OpenedRun::OpenedRun(const PackingJob& job, EarlierRun earlier, std::string_view advice, const Say& say,
                     const InsertionWatch& watch) {
  if (!job.resume) begin_.emplace(begin_run(job, say, watch));
  directory_.emplace(job.files.directory);
  lock_.emplace(job.files.directory);
  remove_leftovers(job.files);
  if (earlier == EarlierRun::replace) remove_files(job.files);
  if (earlier == EarlierRun::refuse) {
    if (const auto there = files_there(job.files); !there.empty()) {
      throw InputError(fmt::format("{} is there already, of a run before{}", there.front().string(), advice));
    }
  }
  if (job.resume) begin_.emplace(begin_run(job, say, watch));
}

PackingEndState run_scene(const SceneText& text, const PackingScene& scene, const RunOptions& options) {
  const PackingJob job = job_of(text, scene, options);
  OpenedRun opened(job, options.earlier, ", which is neither to be resumed nor replaced", options.say,
                   filling_watch(options.asked_to_stop, options.say, std::cerr, false));
  return run_packing_session(job, opened.begin(),
                             {.asked_to_stop = options.asked_to_stop,
                              .say = options.say,
                              .terminal = std::cerr,
                              .watched = false,
                              .sampled = options.sampled});
}

}  // namespace fiberchain::dem
