#include "compare/bench/sizes.hpp"

#include <fmt/format.h>

#include "compare/bench/timing.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/scene.hpp"

namespace fiberchain::compare {
namespace {

struct Kind {
  double diameter;  ///< [mm]
  int aspect_ratio, count;
};

struct Mixture {
  const char* name;
  std::vector<Kind> kinds;
};

/// As many spheres each, but for one body.
std::vector<Mixture> mixtures() {
  return {
      {"one size", {{0.2, 10, 1800}}},
      {"one body of 200 times the diameter", {{40, 1, 1}, {0.2, 10, 1800}}},
      {"1 to 100 mixed",
       {{20, 1, 3}, {10, 2, 8}, {4.5, 5, 30}, {2, 10, 80}, {1, 10, 200}, {0.45, 10, 500}, {0.2, 10, 1000}}}};
}

dem::PackingScene scene_of(const Mixture& mixture, int fewer) {
  std::string text = "scene: packing\nfibers:\n";
  for (const Kind& kind : mixture.kinds) {
    text += fmt::format(
        "  - {{diameter: {} mm, aspect_ratio: {}, youngs_modulus: 3 MPa, poisson_ratio: 0.3, density: 1000, "
        "bond: {{damping: 0.2}}, count: {}}}\n",
        kind.diameter, kind.aspect_ratio, (kind.count + fewer - 1) / fewer);
  }
  text +=
      "filling: {region: {z: [1 mm, 150 mm]}, seed: 9, velocity: [0, 0, -1]}\n"
      "walls: {youngs_modulus: 3 MPa, poisson_ratio: 0.3, box: {x: 90 mm, y: 90 mm, lid: open}}\n"
      "gravity: [0, 0, -9.81]\n"
      "contacts: {restitution: 0.4, friction: 0.4}\n"
      "motion: {step: 0.7 us}\n"
      "steps: 10000\n";
  return std::get<dem::PackingScene>(dem::parse_scene({mixture.name, text}));
}

SizesTime time_of(const Mixture& mixture, const BenchOptions& options) {
  const std::int64_t steps = options.quick ? 300 : 1500;
  dem::PackingStart start = dem::packing_start(scene_of(mixture, options.quick ? 10 : 1), 1);
  start.options.time_parts = true;
  dem::Assembly assembly = dem::make_assembly(std::move(start));
  const double before = assembly.times().search;
  const double seconds = time_once([&] { assembly.march(steps); });
  const double unit = 1e9 / static_cast<double>(assembly.spheres() * steps);
  return {mixture.name, assembly.spheres(), unit * seconds, unit * (assembly.times().search - before)};
}

}  // namespace

std::vector<SizesTime> sizes_times(const BenchOptions& options) {
  std::vector<SizesTime> fastest;
  for (int round = 0; round < (options.quick ? 1 : 7); ++round) {
    std::size_t n = 0;
    for (const Mixture& mixture : mixtures()) {
      const SizesTime time = time_of(mixture, options);
      if (round == 0) {
        fastest.push_back(time);
      } else if (time.all < fastest[n].all) {
        fastest[n] = time;
      }
      ++n;
    }
  }
  return fastest;
}

dem::Table sizes_time_table(const std::vector<SizesTime>& times) {
  return tabulate(times, [&](const SizesTime& t) -> dem::NamedRow {
    return {{"sizes", t.sizes},
            {"spheres", t.spheres},
            {"sphere_step_ns", t.all},
            {"search_ns", t.search},
            {"sphere_step_ratio", t.all / times.front().all}};
  });
}

}  // namespace fiberchain::compare
