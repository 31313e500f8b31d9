#include "compare/bench/stiff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/bench/timing.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::compare {
namespace {

using dem::Integrator;
using Vec3 = dem::Vec<double, 3>;

constexpr double kPathLoad = 0.5;  // P L^2 / (E I)

PrecisionProblem named_apart(PrecisionProblem problem) {
  problem.id = "stiff-" + problem.id;
  return problem;
}

double period_time(const PrecisionProblem& problem, const PrecisionRow& row) {
  return row.time.least / problem.periods;
}

/// Rows and columns of parallel fibers between walls, all spheres pressed against those beside, above and
/// below.
dem::PackingStart stacked(dem::PackingStart start, std::int64_t fibers) {
  const dem::Chain<3> chain = start.groups.front().chain;
  const double pitch = chain.fiber.diameter * (1 - 1e-4);
  const auto columns = static_cast<std::int64_t>(std::sqrt(static_cast<double>(fibers)));
  dem::FiberGroup group{chain, {}};
  for (std::int64_t n = 0; n < columns * columns; ++n) {
    const Vec3 first{0, static_cast<double>(n % columns) * pitch, static_cast<double>(n / columns) * pitch};
    group.fibers.push_back(dem::placed(chain, dem::FiberStart{first, {1, 0, 0}}));
  }
  start.groups = {std::move(group)};
  start.domain.period = {};
  start.domain.walls.clear();
  const double low = -0.5 * pitch, high = (static_cast<double>(columns) - 0.5) * pitch;
  for (const int axis : {1, 2}) {
    Vec3 normal{}, near{}, far{};
    normal[axis] = 1, near[axis] = low, far[axis] = high;
    start.domain.walls.push_back({dem::Plane{near, normal}});
    start.domain.walls.push_back({dem::Plane{far, -1.0 * normal}});
  }
  return start;
}

/// Marches in windows and keeps what the fastest took.
class SchemeTimer {
 public:
  SchemeTimer(const dem::PackingScene& scene, const std::string& bed) : duration_(scene.duration) {
    dem::PackingStart start = dem::packing_start(scene, 1);
    if (bed == "stack") start = stacked(std::move(start), dem::fibers_in(scene));
    start.options.time_parts = true, start.options.account_energy = false;
    const dem::Fiber& fiber = scene.kinds.front().fiber;
    time_ = {fiber.bond_damping,
             bed,
             scene.integrator,
             *start.options.step,
             *start.options.step / dem::bond_time_step(fiber),
             0,
             std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity(),
             0,
             0,
             0};
    assembly_.emplace_back(dem::make_assembly(std::move(start)));
    assembly().march(5);  // memory and caches are cold
    begin_ = assembly().times().search, first_ = assembly().steps();
  }

  void march(std::int64_t steps) {
    const dem::StepTimes last = assembly().times();
    assembly().march(steps);
    const dem::StepTimes now = assembly().times();
    const double unit = 1e9 / static_cast<double>(steps * assembly().spheres());
    time_.bonds = std::min(time_.bonds, unit * (now.bonds_and_motion - last.bonds_and_motion));
    time_.contacts = std::min(time_.contacts, unit * (now.contacts - last.contacts));
  }

  StiffStepTime time() {
    const auto steps = static_cast<double>(assembly().steps() - first_),
               spheres = static_cast<double>(assembly().spheres());
    StiffStepTime time = time_;
    time.contacts_a_sphere = static_cast<double>(assembly().touching()) / spheres;
    time.search = 1e9 * (assembly().times().search - begin_) / (steps * spheres);
    time.slice = steps * time.step;
    time.scene_time = 1e-9 * time.all() * spheres * duration_ / time.step;
    return time;
  }

 private:
  dem::Assembly& assembly() { return assembly_.front(); }

  double duration_;  // of the scene [s]
  StiffStepTime time_;
  std::vector<dem::Assembly> assembly_;
  double begin_ = 0;
  std::int64_t first_ = 0;
};

}  // namespace

std::vector<PrecisionProblem> stiff_release_problems(const BenchOptions& options) {
  BenchOptions alone = options;
  alone.leapfrogs_alone = true;
  std::vector<PrecisionProblem> problems;
  for (const int aspect_ratio : options.quick ? std::vector{10, 20} : std::vector{10, 20, 50, 100}) {
    problems.push_back(named_apart(damping_problem(aspect_ratio, alone)));
    problems.push_back(named_apart(history_problem(aspect_ratio, kPathLoad, alone)));
  }
  return problems;
}

dem::Table release_time_table(const std::vector<PrecisionProblem>& problems) {
  dem::Table table({"problem", "aspect_ratio", "method", "setting", "error", "reference_error", "period_time",
                    "times_faster", "status"});
  for (const PrecisionProblem& problem : problems) {
    const PrecisionRow& plain = problem.rows.at(
        std::ranges::find(problem.rows, dem::name(Integrator::leapfrog), &PrecisionRow::method) -
        problem.rows.begin());
    for (const PrecisionRow& row : problem.rows) {
      if (!row.in_time) continue;
      table.append({{"problem", problem.id},
                    {"aspect_ratio", std::int64_t{row.aspect_ratio}},
                    {"method", row.method},
                    {"setting", row.setting},
                    {"error", row.error},
                    {"reference_error", problem.reference_error},
                    {"period_time", period_time(problem, row)},
                    {"times_faster", plain.time.least / row.time.least},
                    {"status", row.status}});
    }
  }
  return table;
}

std::vector<StiffStepTime> stiff_step_times(const dem::PackingScene& scene, const BenchOptions& options) {
  const int rounds = options.quick ? 3 : 60;
  const std::int64_t window = options.quick ? 4 : 20;
  std::vector<StiffStepTime> times;
  for (const double bond_damping : {0.1, 1.0}) {
    for (const char* bed : {"falling", "stack"}) {
      dem::PackingScene plain = scene;
      plain.step.reset();
      plain.kinds.front().fiber.bond_damping = bond_damping;
      if (options.quick) plain.kinds.front().count = std::min<std::int64_t>(plain.kinds.front().count, 100);
      dem::PackingScene stiff = plain;
      plain.integrator = Integrator::leapfrog, stiff.integrator = Integrator::leapfrog_stiff;
      SchemeTimer explicitly(plain, bed), solved(stiff, bed);
      for (int n = 0; n < rounds; ++n) explicitly.march(window), solved.march(window);
      times.push_back(explicitly.time()), times.push_back(solved.time());
    }
  }
  return times;
}

dem::Table stiff_step_table(const std::vector<StiffStepTime>& times) {
  const StiffStepTime* plain = nullptr;
  return tabulate(times, [&](const StiffStepTime& t) -> dem::NamedRow {
    if (t.integrator == Integrator::leapfrog) plain = &t;
    return {{"bond_damping", t.bond_damping},
            {"bed", t.bed},
            {"integrator", std::string(dem::name(t.integrator))},
            {"time_step", t.step},
            {"step_ratio", t.step_ratio},
            {"coordination", 2 * t.contacts_a_sphere},
            {"bonds_ns", t.bonds},
            {"contacts_ns", t.contacts},
            {"search_ns", t.search},
            {"sphere_step_ns", t.all()},
            {"sphere_step_ratio", t.all() / plain->all()},
            {"slice", t.slice},
            {"expected_time", t.scene_time},
            {"times_faster", plain->scene_time / t.scene_time}};
  });
}

}  // namespace fiberchain::compare
