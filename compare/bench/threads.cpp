#include "compare/bench/threads.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "compare/bench/schedule_model.hpp"
#include "compare/bench/timing.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::compare {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What an assembly has spent in some of its steps.
struct Spent {
  double all = 0;  ///< [s a step]
  dem::StepTimes times{};
  dem::IdleTimes idle;
  std::vector<dem::PartTimes> parts;
};

/// Marches in windows and sums what they cost.
class Marcher {
 public:
  Marcher(const dem::PackingScene& scene, int threads) : assembly_(assembly_of(scene, threads)) {}

  /// Steps whose cost does not count.
  void skip(std::int64_t steps) {
    assembly_.march(steps);
    times_before_ = assembly_.times(), idle_before_ = assembly_.idle_times(),
    parts_before_ = assembly_.part_times();
  }
  void march(std::int64_t steps) {
    seconds_ += time_once([&] { assembly_.march(steps); });
    steps_ += steps;
  }

  std::int64_t spheres() const { return assembly_.spheres(); }

  /// A step, on the average.
  Spent spent() const {
    const double share = 1 / static_cast<double>(steps_);
    const dem::StepTimes times = assembly_.times();
    Spent spent{
        share * seconds_,
        {share * (times.bonds_and_motion - times_before_.bonds_and_motion),
         share * (times.contacts - times_before_.contacts), share * (times.search - times_before_.search)},
        assembly_.idle_times() - idle_before_,
        assembly_.part_times()};
    for (double* idle : {&spent.idle.start, &spent.idle.dependencies, &spent.idle.end, &spent.idle.serial})
      *idle *= share;
    for (std::size_t k = 0; k < spent.parts.size(); ++k) {
      dem::PartTimes& part = spent.parts[k];
      part.contacts = share * (part.contacts - parts_before_[k].contacts);
      part.bonds_and_motion = share * (part.bonds_and_motion - parts_before_[k].bonds_and_motion);
    }
    return spent;
  }

 private:
  static dem::Assembly assembly_of(const dem::PackingScene& scene, int threads) {
    dem::PackingStart start = dem::packing_start(scene, threads);
    start.options.time_parts = true;
    return dem::make_assembly(std::move(start));
  }

  dem::Assembly assembly_;
  dem::StepTimes times_before_{};
  dem::IdleTimes idle_before_;
  std::vector<dem::PartTimes> parts_before_;
  double seconds_ = 0;
  std::int64_t steps_ = 0;
};

struct Measured {
  std::string scene;
  std::int64_t spheres;
  Spent one, two;
};

Measured measured(const NamedScene& scene, const BenchOptions& options) {
  const std::int64_t before = options.quick ? 200 : 3000, window = 50;
  Marcher one(scene.scene, 1), two(scene.scene, 2);
  one.skip(before), two.skip(before);
  for (int n = 0; n < (options.quick ? 4 : 60); ++n) one.march(window), two.march(window);
  return {scene.name, one.spheres(), one.spent(), two.spent()};
}

/// What one thread does alone is seen where a second one waits for it; the first step of a window has no
/// wave.
StepWork work_of(const Measured& m) {
  double waves = 0;
  for (const dem::PartTimes& part : m.one.parts) waves += part.contacts + part.bonds_and_motion;
  const double serial = m.two.idle.serial;
  return {m.one.parts, m.one.all - waves - serial, serial};
}

/// Two threads' time with work over one's, and what of their idle time the schedule does not make.
SharingCosts costs_of(const Measured& m) {
  const double busy = 2 * m.two.all - m.two.idle.sum() - m.two.idle.serial;
  SharingCosts costs{busy / (m.one.all - m.two.idle.serial), 0};
  costs.meeting = std::max(0.0, m.two.all - modeled_step(work_of(m), 2, costs));
  return costs;
}

}  // namespace

std::vector<ThreadRow> thread_times(const std::vector<NamedScene>& scenes, const BenchOptions& options) {
  std::vector<ThreadRow> rows;
  SharingCosts costs{};
  for (std::size_t n = 0; n < scenes.size(); ++n) {
    const Measured m = measured(scenes[n], options);
    if (n == 0) costs = costs_of(m);
    const StepWork work = work_of(m);
    for (const int threads : {1, 2, 4, 16, 64}) {
      const double modeled = modeled_step(work, threads, costs);
      ThreadRow row{m.scene, m.spheres, threads, unknown, modeled, m.one.all / modeled,
                    unknown, unknown,   unknown, unknown};
      if (threads <= 2) {
        const Spent& spent = threads == 1 ? m.one : m.two;
        const double all = threads * spent.all;
        row.measured = spent.all;
        row.start = spent.idle.start / all, row.dependencies = spent.idle.dependencies / all;
        row.end = spent.idle.end / all, row.serial = spent.idle.serial / all;
      }
      rows.push_back(row);
    }
  }
  return rows;
}

dem::Table thread_table(const std::vector<ThreadRow>& rows) {
  return tabulate(rows, [](const ThreadRow& row) -> dem::NamedRow {
    return {{"scene_file", row.scene},
            {"spheres", row.spheres},
            {"threads", std::int64_t{row.threads}},
            {"step_time", row.measured},
            {"step_time_modeled", row.modeled},
            {"speedup_modeled", row.speedup},
            {"idle_start", row.start},
            {"idle_dependencies", row.dependencies},
            {"idle_end", row.end},
            {"idle_serial", row.serial}};
  });
}

}  // namespace fiberchain::compare
