#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "dem/record/errors.hpp"
#include "dem/run/memory.hpp"
#include "dem/run/session.hpp"
#include "dem/run/start_from.hpp"
#include "dem/scene/scene_keys.hpp"
#include "dem/trajectory/h5md.hpp"

namespace fiberchain::dem {
namespace {

/// Instruction sets that a run may have: the one asked for, or those of this processor, the widest first.
std::vector<InstructionSet> sets_of(const PackingJob& job) {
  if (job.instruction_set) {
    require_supported(*job.instruction_set);
    return {*job.instruction_set};
  }
  std::vector<InstructionSet> sets = available_instruction_sets();
  std::ranges::reverse(sets);
  return sets;
}

/// Refuses to overwrite a trajectory beyond its first frame where no checkpoint exists.
void refuse_what_is_there(const RunFiles& files) {
  const auto trajectory = files.trajectory();
  if (!std::filesystem::exists(trajectory)) return;
  constexpr const char* advice = "no checkpoint is there to go on from; --force begins anew";
  std::int64_t last = 0;
  try {
    const TrajectoryReader reader(trajectory);
    if (reader.frames() > 0) last = reader.steps().back();
  } catch (const ReadError& error) {
    throw InputError(fmt::format("{}; {}", error.what(), advice));
  }
  if (last == 0) return;
  throw InputError(
      fmt::format("{}: holds a run up to step {}, of which {}", trajectory.string(), last, advice));
}

}  // namespace

RunBegin begin_run(const PackingJob& job, const Say& say, const InsertionWatch& watch) {
  require_memory(job.scene);
  const std::vector<InstructionSet> sets = sets_of(job);
  if (job.resume) {
    const auto checkpoint =
        find_checkpoint(job.files, scene_keys(job.text), programs_of(job.provenance, sets), say);
    if (checkpoint) {
      const Continued from{job.files.checkpoint(), *checkpoint};
      RunBegin begin = continued(job, from, sets, say);
      begin.resumed = true;
      begin.written = checkpoint->written;
      return begin;
    }
    refuse_what_is_there(job.files);
    say("no checkpoint to go on from: the run begins anew");
  }
  if (job.scene.start_from) return started_from(job, sets, say, watch);
  PackingStart start = packing_start(job.scene, job.threads, watch);
  start.options.instruction_set = sets.front();
  const StepChoice choice = start.choice;
  const std::int64_t steps = start.steps;
  return {.assembly = make_assembly(std::move(start)),
          .choice = choice,
          .steps = steps,
          .instruction_set = sets.front(),
          .scene = job.scene};
}

}  // namespace fiberchain::dem
