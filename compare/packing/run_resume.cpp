#include <fmt/format.h>

#include <utility>

#include "compare/errors.hpp"
#include "compare/packing/run_session.hpp"
#include "dem/errors.hpp"

namespace fiberchain::compare {
namespace {

/// An assembly of the fibers that are there after so many steps, anywhere: their state comes from a
/// checkpoint.
dem::Assembly stand_ins(const dem::io::PackingScene& scene, dem::io::PackingStart start, std::int64_t step) {
  for (int n = 1; n < scene.batches.number; ++n) {
    if (dem::io::batch_step(scene, n, *start.options.step) > step) break;
    dem::io::PackingScene first = scene;  // at the start of time, where every other batch is away
    first.batches.interval = 0;
    for (dem::FiberGroup& group : dem::io::packing_batch(first, n, {}))
      start.groups.push_back(std::move(group));
  }
  return dem::io::make_assembly(std::move(start));
}

void restore(dem::Assembly& assembly, const dem::io::Checkpoint& checkpoint, const RunFiles& files) {
  try {
    assembly.restore(checkpoint.state);
  } catch (const dem::InvalidInput& error) {
    throw InputError(fmt::format("{}: {}", files.checkpoint().string(), error.what()));
  }
  if (assembly.steps() != checkpoint.step) {
    throw InputError(fmt::format("{}: says it is of step {}, its state of {}", files.checkpoint().string(),
                                 checkpoint.step, assembly.steps()));
  }
}

}  // namespace

RunBegin begin_run(const PackingJob& job, const Say& say) {
  dem::io::PackingStart start = dem::io::packing_start(job.scene, job.threads);
  const dem::StepChoice choice = start.choice;
  const std::int64_t steps = start.steps;
  if (job.resume) {
    const auto checkpoint = find_checkpoint(job.files, dem::io::scene_fingerprint(job.text, job.scene),
                                            program_of(job.provenance), say);
    if (checkpoint) {
      RunBegin begin{stand_ins(job.scene, std::move(start), checkpoint->step), choice, steps, true};
      restore(begin.assembly, *checkpoint, job.files);
      say(fmt::format("going on from step {} of {}, t = {:.6g} s", checkpoint->step, steps,
                      checkpoint->time));
      return begin;
    }
    say("no checkpoint to go on from: the run begins anew");
  }
  return {dem::io::make_assembly(std::move(start)), choice, steps};
}

}  // namespace fiberchain::compare
