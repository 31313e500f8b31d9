#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "dem/record/provenance.hpp"
#include "dem/run/files.hpp"
#include "dem/run/samples.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/simd/instruction_set.hpp"

// A run of many fibers to its end, with its files.
namespace fiberchain::dem {

/// What is run, and where.
struct PackingJob {
  SceneText text;
  PackingScene scene;
  RunFiles files;
  int threads = 1;
  bool resume = false;  ///< go on from the last checkpoint, if there is one
  Provenance provenance;
  /// Of the inner loops; left out: a resumed run's own, else the widest that this processor has.
  std::optional<InstructionSet> instruction_set = std::nullopt;
};

/// Who is told what, and who may stop the run.
struct PackingWatchers {
  std::function<bool()> asked_to_stop;                ///< the run then writes a checkpoint and ends
  Say say;                                            ///< messages
  std::ostream& terminal;                             ///< shows where the run stands...
  bool watched;                                       ///< ... if somebody watches
  std::function<void(const Assembly&)> sampled = {};  ///< called at every sample of the log, where given
  /// In place of Assembly::march, where given: another engine marches, and gives back an assembly that is so
  /// many steps on. It is then asked for whole intervals of output only.
  std::function<void(Assembly&, std::int64_t steps)> march = {};
};

/// What the parts of a run have had of the processors [s].
struct RunTimes {
  double march = 0, samples = 0, frames = 0, checkpoints = 0;

  double output() const { return samples + frames + checkpoints; }
};

struct PackingEndState {
  StepChoice choice;
  double step;                ///< [s]
  std::int64_t steps;         ///< of the whole run
  std::int64_t begun_at = 0;  ///< steps that were there before
  RunMoment last{};
  double coordination = std::numeric_limits<double>::quiet_NaN();  ///< contacts of a sphere with spheres that
                                                                   ///< it is not bonded to; NaN if it blew up
  double run_time = 0;                                             ///< of this session [s]
  std::string failure = {};              ///< why it blew up, or that a batch found no room; "" if neither
  std::int64_t fibers = 0, spheres = 0;  ///< that are in
  int next_batch = 0;             ///< the first batch that found no room, numbered from 0; 0 if all are in
  std::int64_t checkpointed = 0;  ///< step of the last checkpoint
  RunTimes times = {};            ///< of this session

  bool finished() const { return failure.empty() && last.step == steps; }
};

/// Where a run begins: at the start of its scene, at a checkpoint, or where the scene's file left off.
struct RunBegin {
  Assembly assembly;
  StepChoice choice;
  std::int64_t steps;    ///< of the whole run
  bool resumed = false;  ///< from a checkpoint of its own, behind what its files have
  InstructionSet instruction_set = best_instruction_set();
  std::vector<std::int64_t> inserted = {};  ///< fibers of each group that came after the start
  PackingScene scene = {};                  ///< with what it has from a file
  WrittenSteps written = {};                ///< what stands in the files of a run that is resumed
};

/// @throws InputError for checkpoints that cannot be used, dem::InvalidInput, also for want of memory,
/// dem::NoRoom, what the watch throws
RunBegin begin_run(const PackingJob& job, const Say& say, const InsertionWatch& watch = {});

/// Which binary runs, with which inner loops, to the bit: what a checkpoint is written and refused by.
std::string program_of(const Provenance& provenance, InstructionSet set);

/// Writes the trajectory, the log and checkpoints as the scene asks. A run that blows up ends with its
/// reason; its files are those of before.
/// A batch of fibers that finds no room ends it likewise, with a checkpoint, where the scene says so.
/// @throws OutputError; the checkpoint before then still stands
PackingEndState run_packing_session(const PackingJob& job, RunBegin begin, const PackingWatchers& watchers);

}  // namespace fiberchain::dem
