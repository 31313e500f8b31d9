#include "dem/run/session.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "dem/model/errors.hpp"
#include "dem/motion/stiff_limits.hpp"
#include "dem/record/errors.hpp"
#include "dem/record/run_status.hpp"
#include "dem/run/break_log.hpp"
#include "dem/run/companions.hpp"
#include "dem/run/filling_watch.hpp"
#include "dem/run/held_log.hpp"
#include "dem/run/insertion_queue.hpp"
#include "dem/run/overlaps.hpp"
#include "dem/run/processor_time.hpp"
#include "dem/run/schedule.hpp"
#include "dem/run/session_words.hpp"
#include "dem/run/wall_log.hpp"
#include "dem/scene/carry_over.hpp"
#include "dem/scene/expected_impact.hpp"
#include "dem/scene/scene_keys.hpp"

namespace fiberchain::dem {
namespace {

/// Steps between two checks for a request to stop.
constexpr std::int64_t kStride = 64;

CompanionsOf companions_of(const PackingJob& job, const RunSchedule& schedule, const WrittenSteps& written) {
  return {.files = job.files,
          .log = run_log_table(job.scene),
          .wall_log = wall_log_table(),
          .walls = job.scene.domain.walls.size(),
          .held_log = held_log_table(),
          .held = job.scene.held.size(),
          .break_log = break_log_table(),
          .breaks = bonds_break(job.scene),
          .provenance = job.provenance,
          .header = {.author = "fiberchain",
                     .creator_version = job.provenance.version,
                     .provenance = entries(job.provenance),
                     .growing = job.scene.batches.number > 1,
                     .contacts = job.scene.output.contacts,
                     .walls = wall_surfaces(job.scene)},
          .vtk = job.scene.output.vtk,
          .schedule = schedule,
          .written = written};
}

/// The files of a run as they grow.
class RunWriter {
 public:
  /// Goes on behind what was written up to `done` steps, or begins.
  RunWriter(const PackingJob& job, const RunSchedule& schedule, const RunBegin& begin, std::int64_t done,
            const Say& say)
      : job_(job),
        schedule_(schedule),
        set_(begin.instruction_set),
        written_(begin.written),
        fingerprint_(scene_fingerprint(job.text, job.scene)),
        keys_(to_text(scene_keys(job.text))),
        files_(begin.resumed ? resume_companions(companions_of(job, schedule, written_), done, say)
                             : begin_companions(companions_of(job, schedule, written_))) {}

  void write_line(const RunMoment& moment, const Pace& pace) {
    files_.log->append(
        run_log_row(moment, job_.scene, pace.step_rate(moment.step), pace.time_left(moment.step)));
    written_.log = moment.step;
  }

  void write_forces(const Assembly& assembly) {
    if (files_.walls) files_.walls->append(wall_log_rows(assembly));
    if (files_.held) files_.held->append(held_log_rows(assembly));
  }

  void write_breaks(Assembly& assembly) {
    if (!files_.breaks) return;
    const Table rows = break_log_rows(assembly);
    if (!rows.rows().empty()) files_.breaks->append(rows);
  }

  void write_frame(const Assembly& assembly, const std::vector<std::int64_t>& inserted) {
    fill_frame(assembly, job_.scene, inserted, frame_);
    frame_.walls_as_before = walls_stay(job_.scene, time_of_frame_before(assembly), frame_.time);
    const Scalars scalars = {{"contacts", static_cast<double>(assembly.touching())}};
    files_.trajectory->append(frame_, scalars);
    written_.trajectory = frame_.step;
    if (!files_.vtk) return;
    files_.vtk->append(frame_);
    written_.vtk = frame_.step;
  }

  void write_checkpoint(const Assembly& assembly, const std::vector<std::int64_t>& inserted) const {
    if (files_.log) files_.log->flush();
    if (files_.walls) files_.walls->flush();
    if (files_.held) files_.held->flush();
    if (files_.breaks) files_.breaks->flush();
    dem::write_checkpoint(job_.files.checkpoint(),
                          {.program = program_of(job_.provenance, set_),
                           .threads = job_.threads,
                           .scene_sha256 = fingerprint_,
                           .scene = job_.text.text,
                           .keys = keys_,
                           .step = assembly.steps(),
                           .time = assembly.time(),
                           .inserted = inserted,
                           .kinds = kinds_of_groups(job_.scene, inserted),
                           .carried = pairs_of(job_.scene.carried),
                           .batches_done = job_.scene.batches.done,
                           .written = written_,
                           .state = {}},
                          [&](const UseField& use) { assembly.each_saved(use); });
  }

 private:
  /// Not a number without one: the same for a run that goes on.
  double time_of_frame_before(const Assembly& assembly) const {
    const std::int64_t before = schedule_.frames.before(assembly.steps());
    return before < 0 ? std::nan("")
                      : assembly.time() - static_cast<double>(assembly.steps() - before) * assembly.step();
  }

  const PackingJob& job_;
  RunSchedule schedule_;
  InstructionSet set_;
  WrittenSteps written_;
  std::string fingerprint_, keys_;
  Companions files_;
  TrajectoryFrame frame_{};  ///< its memory is kept from one to the next
};

/// Says a warning of each kind once, when it begins.
class OverlapWatch {
 public:
  void look_at(const RunMoment& moment, const Say& say) {
    tell(impact_warning(moment), moment.time, impact_told_, say);
    tell(rest_warning(moment), moment.time, rest_told_, say);
  }

 private:
  static void tell(const std::string& warning, double time, bool& told, const Say& say) {
    if (told || warning.empty()) return;
    told = true;
    say(fmt::format("t = {:.4g} s: {}", time, warning));
  }

  bool impact_told_ = false, rest_told_ = false;
};

/// Marches and writes until the end, or until asked to stop.
class Session {
 public:
  Session(const PackingJob& job, const PackingWatchers& watchers, RunBegin begin)
      : job_(job),
        watchers_(watchers),
        assembly_(std::move(begin.assembly)),
        steps_(begin.steps),
        schedule_(job.scene.output, begin.steps),
        batches_(job.scene, assembly_, std::move(begin.inserted),
                 filling_watch(watchers.asked_to_stop, watchers.say, watchers.terminal, watchers.watched)),
        pace_(assembly_.steps(), begin.steps),
        writer_(job, schedule_, begin, assembly_.steps(), watchers.say),
        last_(measure(assembly_, job.scene)),
        checkpointed_(assembly_.steps()),
        written_(begin.resumed ? assembly_.steps() : -1) {
    if (!begin.resumed) write_due(true);
  }

  void run() {
    StatusDisplay display(watchers_.terminal, watchers_.watched);
    while (assembly_.steps() < steps_) {
      const std::int64_t now = assembly_.steps();
      if (watchers_.asked_to_stop()) {
        if (checkpointed_ != now) write_checkpoint();
        return;
      }
      const std::int64_t due = std::min(schedule_.after(now), batches_.next_step(now)),
                         next = watchers_.march ? due : std::min(due, now + kStride);
      if (next > now) march(next - now, next);
      batches_.insert_due(assembly_);
      write_due();
      display.show({next, assembly_.time(), last_.contacts, last_.energy.kinetic, last_.height,
                    pace_.step_rate(next), pace_.time_left(next)},
                   steps_);
    }
  }

  /// Brings to the disk what is due now, and a checkpoint.
  void write_all() {
    write_due();
    if (checkpointed_ != assembly_.steps()) write_checkpoint();
  }

  const Assembly& assembly() const { return assembly_; }
  const InsertionQueue& batches() const { return batches_; }
  const RunMoment& last() const { return last_; }
  std::int64_t checkpointed() const { return checkpointed_; }
  const RunTimes& times() const { return times_; }

 private:
  void march(std::int64_t steps, std::int64_t to) {
    const ProcessorTimer timer(times_.march);
    if (watchers_.march) return watchers_.march(assembly_, steps);
    const bool kept = job_.scene.output.contacts && schedule_.frames.holds(to);
    assembly_.march(steps, kept ? ContactForces::kept : ContactForces::not_kept);
    writer_.write_breaks(assembly_);
  }

  /// The checkpoint last: whatever it stands for is written by then. At the start all that the scene wants.
  void write_due(bool at_start = false) {
    const std::int64_t step = assembly_.steps();
    if (step == written_) return;
    written_ = step;
    const auto due = [&](const EvenSteps& steps) { return at_start ? steps.any() : steps.holds(step); };
    if (due(schedule_.samples)) write_sample();
    if (due(schedule_.frames)) {
      const ProcessorTimer timer(times_.frames);
      writer_.write_frame(assembly_, batches_.inserted());
    }
    if (due(schedule_.checkpoints)) write_checkpoint();
  }

  void write_sample() {
    const ProcessorTimer timer(times_.samples);
    last_ = measure(assembly_, job_.scene, room_);
    writer_.write_line(last_, pace_);
    writer_.write_forces(assembly_);
    assembly_.begin_wall_interval();
    assembly_.begin_held_interval();
    overlaps_.look_at(last_, watchers_.say);
    if (watchers_.sampled) watchers_.sampled(assembly_);
  }

  void write_checkpoint() {
    const ProcessorTimer timer(times_.checkpoints);
    writer_.write_checkpoint(assembly_, batches_.inserted());
    checkpointed_ = assembly_.steps();
  }

  const PackingJob& job_;
  const PackingWatchers& watchers_;
  Assembly assembly_;
  std::int64_t steps_;
  RunSchedule schedule_;
  InsertionQueue batches_;
  Pace pace_;
  RunWriter writer_;
  RunMoment last_;
  std::vector<double> room_;  ///< of a sample's numbers
  OverlapWatch overlaps_;
  RunTimes times_;
  std::int64_t checkpointed_;  ///< step of the last checkpoint
  std::int64_t written_;       ///< step up to which log and trajectory are
};

double coordination(const Assembly& assembly) {
  std::int64_t between = 0;
  for (const ContactState& contact : assembly.contacts()) between += is_of_fiber(contact.key.second);
  return 2.0 * static_cast<double>(between) / static_cast<double>(assembly.spheres());
}

void take_counts(const Assembly& assembly, PackingEndState& end) {
  end.spheres = assembly.spheres();
  end.fibers = 0;
  for (int g = 0; g < assembly.groups(); ++g) end.fibers += assembly.fibers(g);
}

void take_end(const Session& session, const PackingJob& job, const PackingWatchers& watchers,
              PackingEndState& end) {
  end.last = measure(session.assembly(), job.scene);
  end.coordination = coordination(session.assembly());
  say_how_deep(end.last, session.assembly().longest_path(), watchers.say);
  if (session.assembly().integrator() == Integrator::leapfrog_stiff) {
    watchers.say(fmt::format("largest turn of a bond in a step {:.2g} rad, allowed {:g}",
                             session.assembly().largest_turn(), largest_turn));
  }
  const int next = session.batches().next();
  if (next < job.scene.batches.number && end.last.step == end.steps) end.next_batch = next;
}

void run_to_end(const PackingJob& job, RunBegin begin, const PackingWatchers& watchers,
                PackingEndState& end) {
  Session session(job, watchers, std::move(begin));
  try {
    session.run();
    take_end(session, job, watchers, end);
  } catch (const Diverged& error) {
    end.failure = error.what();
    end.last = session.last();
  } catch (const NoRoom& error) {
    session.write_all();
    take_end(session, job, watchers, end);
    end.failure = error.what();
  } catch (const Interrupted& stop) {
    watchers.say(stop.what());
    end.last = session.last();
  } catch (const OutputError&) {
    watchers.say(fmt::format("the last checkpoint is of step {}: with --resume the run goes on from there",
                             session.checkpointed()));
    throw;
  }
  end.checkpointed = session.checkpointed();
  end.times = session.times();
  take_counts(session.assembly(), end);
}

}  // namespace

std::string program_of(const Provenance& provenance, InstructionSet set) {
  return fmt::format("fiberchain {}, commit {}, {}, {}, {}", provenance.version, provenance.commit,
                     provenance.compiler, provenance.flags, name(set));
}

PackingEndState run_packing_session(const PackingJob& asked, RunBegin begin,
                                    const PackingWatchers& watchers) {
  const auto clock = std::chrono::steady_clock::now();
  PackingJob job = asked;
  job.scene = begin.scene;
  const double step = begin.assembly.step();
  if (!begin.choice.integrator_reason.empty()) {
    watchers.say(fmt::format("integrator: {} ({})", name(begin.assembly.integrator()),
                             begin.choice.integrator_reason));
  }
  watchers.say(fmt::format("{} fibers, {} spheres, {}; {} steps of {:.4g} s ({})", fibers_in(job.scene),
                           spheres_in(job.scene), mass_words(job.scene), begin.steps, step,
                           step_words(begin.choice, job.scene)));
  const double speed = begin.choice.speed;
  if (speed > 0) watchers.say(expected_impact_in_words(speed, expected_impact_overlap(job.scene, speed)));
  PackingEndState end{
      .choice = begin.choice, .step = step, .steps = begin.steps, .begun_at = begin.assembly.steps()};
  if (end.begun_at >= end.steps) {  // finished before: its files stay as they are
    end.last = measure(begin.assembly, job.scene);
    end.coordination = coordination(begin.assembly);
    take_counts(begin.assembly, end);
    look_at_companions(companions_of(job, RunSchedule(job.scene.output, end.steps), begin.written), end.steps,
                       watchers.say);
  } else {
    run_to_end(job, std::move(begin), watchers, end);
  }
  end.run_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  return end;
}

}  // namespace fiberchain::dem
