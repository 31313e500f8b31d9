#include "compare/bench/smooth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "compare/study/tabulate.hpp"
#include "dem/run/processor_time.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::compare {
namespace {

struct Fallen {
  SmoothTime time;
  dem::Assembly assembly;
  std::vector<double> windows = {};  ///< of the processor: others may use it too [s]
};

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

Fallen fallen(dem::PackingScene scene, const Surface& surface, double step, std::int64_t fall) {
  const double chosen = dem::plan_of(scene).choice.step;
  scene.step = step;
  Fallen one{{surface.smooth ? "smooth" : "spheres", surface.spacing, 0, 0, chosen, 0, 1},
             dem::make_assembly(dem::packing_start(scene, 1))};
  one.assembly.march(fall);
  one.time.spheres = one.assembly.spheres();
  return one;
}

double middle(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

}  // namespace

std::vector<SmoothTime> smooth_times(const dem::PackingScene& scene, const BenchOptions& options) {
  const std::int64_t fall = options.quick ? 6000 : 15000, window = options.quick ? 50 : 200;
  const int rounds = options.quick ? 7 : 31;
  constexpr Surface surfaces[] = {{false, 1}, {true, 1}, {true, 2.5}};
  double step = std::numeric_limits<double>::infinity();
  for (const Surface& surface : surfaces)
    step = std::min(step, dem::plan_of(with_surface(scene, surface)).choice.step);
  std::vector<std::unique_ptr<Fallen>> all;
  for (const Surface& surface : surfaces)
    all.push_back(std::make_unique<Fallen>(fallen(with_surface(scene, surface), surface, step, fall)));
  for (int round = 0; round < rounds; ++round) {
    for (auto& one : all) {
      const dem::ProcessorTimer timer(one->windows.emplace_back(0));
      one->assembly.march(window);
    }
  }
  std::vector<SmoothTime> times;
  for (const auto& one : all) {
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round)
      ratios.push_back(one->windows[round] / all[0]->windows[round]);
    one->time.ratio = middle(ratios);
    one->time.sphere_step = 1e9 * middle(one->windows) / static_cast<double>(one->time.spheres * window);
    one->time.contacts = one->assembly.touching();
    times.push_back(one->time);
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
