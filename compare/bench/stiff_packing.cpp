#include "compare/bench/stiff_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "compare/bench/timing.hpp"
#include "compare/packing/history.hpp"
#include "compare/packing/scene.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/analysis/observables.hpp"
#include "dem/run/samples.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/scene.hpp"

namespace fiberchain::compare {
namespace {

using dem::Integrator;

constexpr int kRestSamples = 10;  // of the last fifth of the time

dem::PackingScene small_scene(const StiffPackingPlan& plan) {
  const std::string text = fmt::format(
      "scene: packing\n"
      "fibers:\n"
      "  - {{diameter: 20 um, aspect_ratio: 20, youngs_modulus: 200 GPa, poisson_ratio: 0.3, density: 7850, "
      "bond: {{damping: {damping}}}, count: {fibers}}}\n"
      "filling:\n"
      "  region: {{x: [0, {side}], y: [0, {side}], z: [1e-4, {height}]}}\n"
      "  velocity: [0, 0, -0.1]\n"
      "  gap: 1 um\n"
      "  seed: 1\n"
      "walls: {{youngs_modulus: 3 MPa, poisson_ratio: 0.3, box: {{x: {side}, y: {side}, lid: open}}}}\n"
      "gravity: [0, 0, -9.81]\n"
      "contacts: {{restitution: 0.4, friction: 0.6, youngs_modulus: 3 MPa, poisson_ratio: 0.3}}\n"
      "duration: {duration}\n",
      fmt::arg("damping", plan.bond_damping), fmt::arg("fibers", plan.fibers), fmt::arg("side", plan.side),
      fmt::arg("height", plan.height), fmt::arg("duration", plan.duration));
  return std::get<dem::PackingScene>(dem::parse_scene({"small packing of steel fibers", text}));
}

/// As asked for: scheme, seed and, where it is given, the step.
dem::PackingScene scene_of(dem::PackingScene scene, const RestingPacking& asked) {
  scene.integrator = asked.integrator;
  scene.filling.seed = asked.seed;
  if (asked.integrator != Integrator::leapfrog)
    scene.step = asked.step_ratio * dem::bond_time_step(scene.kinds.front().fiber);
  return scene;
}

void settle(const dem::PackingScene& scene, RestingPacking& run) {
  dem::PackingStart start = dem::packing_start(scene, 1);
  const std::vector<std::int32_t> fiber_of_sphere = dem::fiber_numbers(start.groups);
  const std::int64_t steps = start.steps;
  dem::Assembly assembly = dem::make_assembly(std::move(start));
  run.step = assembly.step();
  run.step_ratio = run.step / dem::bond_time_step(scene.kinds.front().fiber);
  for (int n = 0; n <= kRestSamples; ++n) {
    assembly.march(steps * (4 * kRestSamples + n) / (5 * kRestSamples) - assembly.steps());
    run.bending += assembly.sample().bending_mean() / (kRestSamples + 1);
  }
  const dem::PlacedSpheres spheres = assembly.placed();
  const dem::Vec<double, 3> up = dem::upward(scene);
  run.solid_fraction =
      dem::solid_fractions(spheres, up, floor_area(scene), {0, dem::heights(spheres, up).quantile}).front();
  run.coordination = dem::coordination(assembly.contacts(), fiber_of_sphere).per_sphere;
  run.overlap_mean = assembly.sample().overlap_mean(), run.overlap_peak = assembly.deepest_overlap();
}

void run_to_rest(const dem::PackingScene& scene, RestingPacking& run) {
  try {
    run.run_time = time_once([&] { settle(scene_of(scene, run), run); });
    run.status = "finished";
  } catch (const std::exception& why) {
    run.status = why.what();
  }
}

struct Observable {
  const char* name;
  double RestingPacking::*value;
};
constexpr Observable kObservables[] = {{"solid fraction", &RestingPacking::solid_fraction},
                                       {"coordination", &RestingPacking::coordination},
                                       {"mean bending angle (rad)", &RestingPacking::bending},
                                       {"mean overlap over R", &RestingPacking::overlap_mean},
                                       {"deepest overlap over R", &RestingPacking::overlap_peak},
                                       {"run time (s)", &RestingPacking::run_time}};

/// Finished runs with the scheme and step of one.
std::vector<const RestingPacking*> seeds_of(const std::vector<RestingPacking>& runs,
                                            const RestingPacking& one) {
  std::vector<const RestingPacking*> same;
  for (const RestingPacking& run : runs) {
    if (run.status == "finished" && run.integrator == one.integrator && run.step_ratio == one.step_ratio)
      same.push_back(&run);
  }
  return same;
}

Spread spread_over(const std::vector<const RestingPacking*>& seeds, const Observable& observable) {
  std::vector<double> values;
  for (const RestingPacking* run : seeds) values.push_back(run->*observable.value);
  return spread_of(values);
}

}  // namespace

std::vector<RestingPacking> resting_packings(const StiffPackingPlan& plan, const Jobs& jobs) {
  std::vector<RestingPacking> runs;
  const auto add = [&](Integrator integrator, double step_ratio) {
    for (int seed = 1; seed <= plan.seeds; ++seed)
      runs.push_back({integrator, step_ratio, static_cast<std::uint64_t>(seed)});
  };
  add(Integrator::leapfrog, nan);
  for (const double step_ratio : plan.step_ratios) add(Integrator::leapfrog_stiff, step_ratio);
  const dem::PackingScene scene = small_scene(plan);
  jobs.run(runs.size(), [&](std::size_t n) { run_to_rest(scene, runs[n]); });
  return runs;
}

dem::Table resting_table(const std::vector<RestingPacking>& runs) {
  return tabulate(runs, [](const RestingPacking& run) -> dem::NamedRow {
    return {{"integrator", std::string(dem::name(run.integrator))},
            {"step_ratio", run.step_ratio},
            {"time_step", run.step},
            {"seed", static_cast<std::int64_t>(run.seed)},
            {"solid_fraction", run.solid_fraction},
            {"coordination", run.coordination},
            {"bending_plateau", run.bending},
            {"overlap_mean", run.overlap_mean},
            {"overlap_peak", run.overlap_peak},
            {"run_time", run.run_time},
            {"status", run.status}};
  });
}

dem::Table step_effect_table(const std::vector<RestingPacking>& runs) {
  dem::Table table(
      {"quantity", "integrator", "step_ratio", "seeds", "mean", "standard_deviation", "off_in_spreads"});
  for (const Observable& observable : kObservables) {
    std::optional<Spread> first;
    const RestingPacking* last = nullptr;
    for (const RestingPacking& run : runs) {
      const bool known = last && last->integrator == run.integrator && last->step_ratio == run.step_ratio;
      if (run.status != "finished" || known) continue;
      last = &run;
      const auto seeds = seeds_of(runs, run);
      const Spread spread = spread_over(seeds, observable);
      if (run.integrator == Integrator::leapfrog) first = spread;
      table.append(
          {{"quantity", std::string(observable.name)},
           {"integrator", std::string(dem::name(run.integrator))},
           {"step_ratio", run.step_ratio},
           {"seeds", static_cast<std::int64_t>(spread.count)},
           {"mean", spread.mean},
           {"standard_deviation", spread.deviation},
           {"off_in_spreads",
            first ? (spread.mean - first->mean) / std::max(spread.deviation, first->deviation) : nan}});
    }
  }
  return table;
}

}  // namespace fiberchain::compare
