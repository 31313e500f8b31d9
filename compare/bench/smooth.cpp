#include "compare/bench/smooth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "compare/bench/turns.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::compare {
namespace {

struct Surface {
  bool smooth;
  double spacing;
};

dem::PackingScene with_surface(dem::PackingScene scene, const Surface& surface) {
  scene.step = {};
  for (dem::PackingFiberKind& kind : scene.kinds) {
    kind.smooth = surface.smooth;
    kind.fiber.aspect_ratio = static_cast<int>(std::lround(kind.fiber.aspect_ratio / surface.spacing));
    kind.fiber.spacing = surface.spacing;
  }
  return scene;
}

}  // namespace

std::vector<SmoothTime> smooth_times(const dem::PackingScene& scene, const BenchOptions& options) {
  const TurnPlan plan = turn_plan(options);
  std::vector<SmoothTime> times;
  std::vector<dem::PackingScene> scenes;
  for (const Surface& surface : {Surface{false, 1}, Surface{true, 1}, Surface{true, 2.5}}) {
    scenes.push_back(with_surface(scene, surface));
    times.push_back({surface.smooth ? "smooth" : "spheres", surface.spacing, 0, 0,
                     dem::plan_of(scenes.back()).choice.step, 0, 1});
  }
  const double step = std::ranges::min(times, {}, &SmoothTime::chosen_step).chosen_step;
  std::vector<std::unique_ptr<dem::Assembly>> packings;
  for (dem::PackingScene& one : scenes) {
    one.step = step;
    packings.push_back(std::make_unique<dem::Assembly>(dem::make_assembly(dem::packing_start(one, 1))));
    packings.back()->march(plan.fall);
  }
  const std::vector<TurnTime> turns = march_in_turns(packings, plan);
  for (std::size_t n = 0; n < times.size(); ++n) {
    times[n].spheres = packings[n]->spheres(), times[n].contacts = packings[n]->touching();
    times[n].sphere_step = turns[n].sphere_step, times[n].ratio = turns[n].ratio;
  }
  return times;
}

dem::Table smooth_time_table(const std::vector<SmoothTime>& times) {
  return tabulate(times, [](const SmoothTime& t) -> dem::NamedRow {
    return {{"surface", t.surface},
            {"spacing", t.spacing},
            {"spheres", t.spheres},
            {"contacts", t.contacts},
            {"sphere_step_ns", t.sphere_step},
            {"packing_time_ratio", t.ratio},
            {"chosen_step", t.chosen_step}};
  });
}

}  // namespace fiberchain::compare
