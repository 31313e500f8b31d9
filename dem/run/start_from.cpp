#include "dem/run/start_from.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "dem/insertion/placement.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/record/errors.hpp"
#include "dem/run/frame_state.hpp"
#include "dem/scene/carry_over.hpp"
#include "dem/scene/scene_keys.hpp"
#include "dem/trajectory/h5md.hpp"

namespace fiberchain::dem {
namespace {

FiberGroup stand_in_group(const Chain<3>& chain, std::int64_t fibers) {
  return {chain, std::vector<ChainState<3>>(static_cast<std::size_t>(fibers),
                                            placed(chain, FiberStart{{}, {1, 0, 0}}))};
}

/// An assembly of the fibers that a checkpoint has, at arbitrary positions: the checkpoint sets their state.
Assembly stand_ins(const PackingScene& scene, PackingStart start, const Checkpoint& checkpoint) {
  std::size_t later = 0;
  for (int n = 1; n < scene.batches.number && later < checkpoint.inserted.size(); ++n) {
    for (const auto& [chain, count] : batch_counts(scene, n)) {
      if (later == checkpoint.inserted.size()) break;
      const std::int64_t fibers = checkpoint.inserted[later++];
      if (fibers < 0 || fibers > count)
        throw InputError(fmt::format("its batch {} has {} fibers, the scene's {}", n + 1, fibers, count));
      if (fibers > 0) start.groups.push_back(stand_in_group(chain, fibers));
    }
  }
  start.options.placed_anywhere = true;
  return make_assembly(std::move(start));
}

void restore(Assembly& assembly, const Continued& from) {
  try {
    assembly.restore(from.checkpoint.state);
  } catch (const InvalidInput& error) {
    throw InputError(fmt::format("{}: {}", from.path.string(), error.what()));
  }
  if (assembly.steps() != from.checkpoint.step) {
    throw InputError(fmt::format("{}: says it is of step {}, its state of {}", from.path.string(),
                                 from.checkpoint.step, assembly.steps()));
  }
}

double step_of(const Continued& from) {
  const auto found = from.checkpoint.state.find("time_step");
  const auto* step = found == from.checkpoint.state.end()
                         ? nullptr
                         : std::get_if<std::vector<double>>(&found->second.values);
  if (step == nullptr || step->size() != 1)
    throw InputError(fmt::format("{}: its state has no time_step", from.path.string()));
  return step->front();
}

/// The scene ends where the file is, or before.
[[noreturn]] void refuse_end(const PackingScene& scene, const std::string& what, double time) {
  const bool in_steps = scene.steps > 0;
  const std::string now =
      in_steps ? fmt::format("steps = {}", scene.steps) : fmt::format("duration = {} s", scene.duration);
  const bool from_file = scene.start_from && scene.start_from->clock == StartClock::as_in_file;
  throw InvalidKey(in_steps ? "steps" : "duration",
                   fmt::format("{} is not allowed: {} is of t = {:.6g} s already{}", now, what, time,
                               from_file ? "; start_from.clock: zero counts from there" : ""));
}

/// With the step of the checkpoint, which a longer duration may have chosen otherwise.
PackingScene with_step(PackingScene scene, const Continued& from, const Say& say) {
  const double step = step_of(from), chosen = plan_of(scene).step;
  if (step == chosen) return scene;
  if (scene.carried.empty()) {
    say(fmt::format("the step stays {:.6g} s; a run of this duration would choose {:.6g} s from its start",
                    step, chosen));
  }
  scene.step = step;
  return scene;
}

/// The checkpoint's own among these; nothing if it is of another program.
std::optional<InstructionSet> set_of(const PackingJob& job, const Checkpoint& checkpoint,
                                     const std::vector<InstructionSet>& sets) {
  const std::vector<std::string> programs = programs_of(job.provenance, sets);
  const auto found = std::ranges::find(programs, checkpoint.program);
  if (found == programs.end()) return std::nullopt;
  return sets[static_cast<std::size_t>(found - programs.begin())];
}

std::string losses_in_words(const CarriedLosses& losses, const CarriedState& state) {
  std::string words;
  if (state.step == 0) {
    words =
        "a frame has no histories: contacts begin without tangential springs, bonds with the stretch and "
        "bending of their spheres' places, without twist, shear and spin";
  } else {
    words = fmt::format("{} of {} contacts keep their history", losses.kept, losses.contacts);
    if (losses.contacts > losses.kept) words += "; that of the others, which are no longer there, is dropped";
  }
  if (losses.bonds_without > 0 && state.step > 0)
    words += fmt::format("; {} bonds are of another form: their strains follow from places and orientations",
                         losses.bonds_without);
  if (losses.branches_without > 0)
    words += fmt::format("; the branches of {} bonds begin at rest", losses.branches_without);
  return words + "; energies are accounted from here on";
}

/// The state of the file, by the scene's clock.
struct StartState {
  CarriedState state;
  std::vector<std::int64_t> kinds;
};

StartState by_clock(StartState start, const PackingScene& scene) {
  if (scene.start_from->clock == StartClock::zero) start.state.time = 0;
  return start;
}

/// Begins with the fibers of a state whose physics may have been another.
RunBegin carried_on(const PackingJob& job, const StartState& from, InstructionSet set, const Say& say,
                    const InsertionWatch& watch) {
  const CarriedState& state = from.state;
  const PackingScene scene = carried_over(job.scene, state, from.kinds);
  PackingStart start = packing_start(scene, job.threads, watch, {groups_of(scene, state), state.time});
  start.options.instruction_set = set;
  const StepChoice choice = start.choice;
  const std::int64_t steps = start.steps;
  if (start.options.steps_before >= steps) refuse_end(scene, "the file of start_from", state.time);
  std::optional<Assembly> assembly;
  try {
    assembly.emplace(make_assembly(std::move(start)));
  } catch (const InvalidKey&) {
    throw;
  } catch (const InvalidInput& error) {
    throw InvalidKey("start_from", error.what());
  }
  const CarriedLosses losses = assembly->take_over(state);
  say(losses_in_words(losses, state));
  return {.assembly = std::move(*assembly),
          .choice = choice,
          .steps = steps,
          .instruction_set = set,
          .scene = scene};
}

/// Fibers would meet themselves or others where the sides come nearer.
[[noreturn]] void refuse_periods(const std::string& words) {
  throw InvalidKey("periodic", fmt::format("{}; the periodic sides must be those of start_from", words));
}

void check_periods(const Checkpoint& checkpoint, const SceneKeys& keys) {
  for (const KeyChange& change : changes_between(scene_keys_in(checkpoint.keys), keys)) {
    if (change.path.starts_with("periodic")) refuse_periods(in_words(change) + " is not allowed");
  }
}

void say_changes(const Checkpoint& checkpoint, const PackingJob& job, const Say& say) {
  const SceneKeys keys = scene_keys(job.text);
  check_periods(checkpoint, keys);
  const std::string other = other_physics(checkpoint, keys);
  if (!other.empty()) say("with " + other);
}

void check_periods(const TrajectoryFrame& frame, const PackingScene& scene) {
  for (int a = 0; a < 3; ++a) {
    const double period = scene.domain.period[a],
                 there = frame.periodic[a] ? frame.high[a] - frame.low[a] : 0.0;
    if (std::abs(period - there) > 1e-9 * there)
      refuse_periods(fmt::format("a period of {} m is not allowed where the frame has {} m", period, there));
  }
}

StartState state_of(const Checkpoint& checkpoint, const StartFile& file) {
  try {
    return {carried_state(checkpoint.state), checkpoint.kinds};
  } catch (const InvalidInput& error) {
    throw InputError(fmt::format("{}: {}", file.path.string(), error.what()));
  }
}

/// The frame that a scene begins with, and its number.
struct StartFrame {
  std::int64_t number;
  TrajectoryFrame frame;
};

StartFrame frame_of(const PackingScene& scene) {
  const StartFile& file = *scene.start_from;
  const TrajectoryReader reader(file.path);
  const std::int64_t last = reader.frames() - 1, frame = file.frame.value_or(last);
  if (last < 0 || frame > last) {
    throw InvalidKey("start_from.frame", fmt::format("frame {} is not allowed: {} has {} frames, from 0 on",
                                                     frame, file.path.string(), last + 1));
  }
  StartFrame start{frame, reader.read(frame)};
  check_periods(start.frame, scene);
  return start;
}

StartState state_of(const TrajectoryFrame& frame, const PackingScene& scene) {
  StartState start{state_of_frame(frame), {}};
  start.kinds = kinds_by_shape(scene, start.state);
  return start;
}

RunBegin from_checkpoint(const PackingJob& job, const std::vector<InstructionSet>& sets, const Say& say,
                         const InsertionWatch& watch) {
  const StartFile& file = *job.scene.start_from;
  const Checkpoint checkpoint = read_checkpoint(file.path);
  const auto set = set_of(job, checkpoint, sets);
  const bool same = other_physics(checkpoint, scene_keys(job.text)).empty();
  if (same && set && file.clock == StartClock::as_in_file)
    return continued(job, {file.path, checkpoint}, sets, say);
  say(fmt::format("start_from: {} of step {}, t = {:.6g} s", file.path.string(), checkpoint.step,
                  checkpoint.time));
  say_changes(checkpoint, job, say);
  if (!set)
    say(fmt::format(
        "it was written by another program or for other instructions ({}): the run need not end in "
        "the same bits",
        checkpoint.program));
  return carried_on(job, by_clock(state_of(checkpoint, file), job.scene), sets.front(), say, watch);
}

RunBegin from_frame(const PackingJob& job, const std::vector<InstructionSet>& sets, const Say& say,
                    const InsertionWatch& watch) {
  const StartFrame read = frame_of(job.scene);
  StartState start = state_of(read.frame, job.scene);
  say(fmt::format("start_from: frame {} of {}, t = {:.6g} s", read.number,
                  job.scene.start_from->path.string(), start.state.time));
  return carried_on(job, by_clock(std::move(start), job.scene), sets.front(), say, watch);
}

}  // namespace

std::vector<std::string> programs_of(const Provenance& provenance, const std::vector<InstructionSet>& sets) {
  std::vector<std::string> programs;
  for (const InstructionSet set : sets) programs.push_back(program_of(provenance, set));
  return programs;
}

RunBegin continued(const PackingJob& job, const Continued& from, const std::vector<InstructionSet>& sets,
                   const Say& say) {
  const Checkpoint& checkpoint = from.checkpoint;
  const InstructionSet set = set_of(job, checkpoint, sets).value_or(sets.front());
  const PackingScene scene =
      with_step(carried_over(job.scene, checkpoint.carried, checkpoint.batches_done), from, say);
  CarriedStart carried;
  for (const CarriedFibers& group : scene.carried)
    carried.groups.push_back(stand_in_group(chain_of(scene.kinds[group.kind]), group.fibers));
  PackingStart start = packing_start(scene, job.threads, {}, carried);
  start.options.instruction_set = set;
  if (checkpoint.step > start.steps) refuse_end(scene, from.path.string(), checkpoint.time);
  const StepChoice choice = start.choice;
  const std::int64_t steps = start.steps;
  RunBegin begin{.assembly = stand_ins(scene, std::move(start), checkpoint),
                 .choice = choice,
                 .steps = steps,
                 .instruction_set = set,
                 .inserted = checkpoint.inserted,
                 .scene = scene};
  restore(begin.assembly, from);
  say(fmt::format("going on from step {} of {}, t = {:.6g} s{}", checkpoint.step, steps, checkpoint.time,
                  set == sets.front() ? "" : fmt::format(", with {} as before", name(set))));
  return begin;
}

RunBegin started_from(const PackingJob& job, const std::vector<InstructionSet>& sets, const Say& say,
                      const InsertionWatch& watch) {
  try {
    return job.scene.start_from->is_trajectory() ? from_frame(job, sets, say, watch)
                                                 : from_checkpoint(job, sets, say, watch);
  } catch (const ReadError& error) {
    throw InvalidKey("start_from", error.what());
  }
}

PackingScene with_start_file(const SceneText& text, const PackingScene& scene) {
  if (!scene.start_from) return scene;
  const StartFile& file = *scene.start_from;
  try {
    StartState start;
    if (file.is_trajectory()) {
      start = state_of(frame_of(scene).frame, scene);
    } else {
      const Checkpoint checkpoint = read_checkpoint(file.path);
      check_periods(checkpoint, scene_keys(text));
      start = state_of(checkpoint, file);
    }
    start = by_clock(std::move(start), scene);
    PackingScene carried = carried_over(scene, start.state, start.kinds);
    const PackingPlan plan = plan_of(carried);
    if (std::llround(start.state.time / plan.step) >= plan.steps)
      refuse_end(carried, "the file of start_from", start.state.time);
    grips_of(carried);
    return carried;
  } catch (const ReadError& error) {
    throw InvalidKey("start_from", error.what());
  } catch (const InputError& error) {
    throw InvalidKey("start_from", error.what());
  }
}

}  // namespace fiberchain::dem
