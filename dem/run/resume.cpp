#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "dem/insertion/placement.hpp"
#include "dem/model/errors.hpp"
#include "dem/record/errors.hpp"
#include "dem/run/memory.hpp"
#include "dem/run/session.hpp"
#include "dem/trajectory/h5md.hpp"

namespace fiberchain::dem {
namespace {

/// An assembly of the fibers that a checkpoint has, at arbitrary positions: the checkpoint sets their state.
Assembly stand_ins(const PackingScene& scene, PackingStart start, const Checkpoint& checkpoint) {
  std::size_t later = 0;
  for (int n = 1; n < scene.batches.number && later < checkpoint.inserted.size(); ++n) {
    for (const auto& [chain, count] : batch_counts(scene, n)) {
      if (later == checkpoint.inserted.size()) break;
      const std::int64_t fibers = checkpoint.inserted[later++];
      if (fibers < 0 || fibers > count)
        throw InputError(fmt::format("its batch {} has {} fibers, the scene's {}", n + 1, fibers, count));
      FiberGroup group{chain, std::vector<ChainState<3>>(static_cast<std::size_t>(fibers),
                                                         placed(chain, FiberStart{{}, {1, 0, 0}}))};
      if (fibers > 0) start.groups.push_back(std::move(group));
    }
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
  PackingStart start = packing_start(job.scene, job.threads, watch);
  start.options.instruction_set = sets.front();
  const StepChoice choice = start.choice;
  const std::int64_t steps = start.steps;
  if (job.resume) {
    std::vector<std::string> programs;
    for (const InstructionSet set : sets) programs.push_back(program_of(job.provenance, set));
    const auto checkpoint = find_checkpoint(job.files, scene_fingerprint(job.text, job.scene), programs, say);
    if (checkpoint) {
      const auto place = std::ranges::find(programs, checkpoint->program) - programs.begin();
      const InstructionSet set = sets[static_cast<std::size_t>(place)];
      start.options.instruction_set = set;
      RunBegin begin{stand_ins(job.scene, std::move(start), *checkpoint),
                     choice,
                     steps,
                     true,
                     set,
                     checkpoint->inserted};
      restore(begin.assembly, *checkpoint, job.files);
      say(fmt::format("going on from step {} of {}, t = {:.6g} s{}", checkpoint->step, steps,
                      checkpoint->time, place > 0 ? fmt::format(", with {} as before", name(set)) : ""));
      return begin;
    }
    refuse_what_is_there(job.files);
    say("no checkpoint to go on from: the run begins anew");
  }
  return {make_assembly(std::move(start)), choice, steps, false, sets.front()};
}

}  // namespace fiberchain::dem
