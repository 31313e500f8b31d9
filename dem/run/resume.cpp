#include <fmt/format.h>

#include <utility>

#include "dem/model/errors.hpp"
#include "dem/record/errors.hpp"
#include "dem/run/session.hpp"
#include "dem/trajectory/h5md.hpp"

namespace fiberchain::dem {
namespace {

/// An assembly of the fibers present after so many steps, at arbitrary positions: a checkpoint sets their
/// state.
Assembly stand_ins(const PackingScene& scene, PackingStart start, std::int64_t step) {
  PackingScene anywhere = scene;  // where walls stand when batches come is not where they stand now
  anywhere.domain.walls.clear();
  for (int n = 1; n < scene.batches.number; ++n) {
    if (batch_step(scene, n, *start.options.step) > step) break;
    for (FiberGroup& group : packing_batch(anywhere, n, 0, {})) start.groups.push_back(std::move(group));
  }
  start.options.placed_anywhere = true;
  return make_assembly(std::move(start));
}

void restore(Assembly& assembly, const Checkpoint& checkpoint, const RunFiles& files) {
  try {
    assembly.restore(checkpoint.state);
  } catch (const InvalidInput& error) {
    throw InputError(fmt::format("{}: {}", files.checkpoint().string(), error.what()));
  }
  if (assembly.steps() != checkpoint.step) {
    throw InputError(fmt::format("{}: says it is of step {}, its state of {}", files.checkpoint().string(),
                                 checkpoint.step, assembly.steps()));
  }
}

/// Refuses to overwrite a trajectory beyond its first frame where no checkpoint exists.
void refuse_what_is_there(const RunFiles& files) {
  const auto trajectory = files.trajectory();
  if (!std::filesystem::exists(trajectory)) return;
  const TrajectoryReader reader(trajectory);
  if (reader.frames() == 0 || reader.steps().back() == 0) return;
  throw InputError(fmt::format(
      "{}: holds a run up to step {}, of which no checkpoint is there to go on from; --force begins anew",
      trajectory.string(), reader.steps().back()));
}

}  // namespace

RunBegin begin_run(const PackingJob& job, const Say& say) {
  PackingStart start = packing_start(job.scene, job.threads);
  const StepChoice choice = start.choice;
  const std::int64_t steps = start.steps;
  if (job.resume) {
    const auto checkpoint =
        find_checkpoint(job.files, scene_fingerprint(job.text, job.scene), program_of(job.provenance), say);
    if (checkpoint) {
      RunBegin begin{stand_ins(job.scene, std::move(start), checkpoint->step), choice, steps, true};
      restore(begin.assembly, *checkpoint, job.files);
      say(fmt::format("going on from step {} of {}, t = {:.6g} s", checkpoint->step, steps,
                      checkpoint->time));
      return begin;
    }
    refuse_what_is_there(job.files);
    say("no checkpoint to go on from: the run begins anew");
  }
  return {make_assembly(std::move(start)), choice, steps};
}

}  // namespace fiberchain::dem
