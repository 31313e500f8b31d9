#include "compare/scenes/scene_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "compare/flow/setup.hpp"
#include "compare/scenes/damping_report.hpp"
#include "compare/scenes/release_report.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/flow/flow_batch.hpp"
#include "dem/run/memory.hpp"
#include "dem/run/packing_estimate.hpp"
#include "dem/run/start_from.hpp"
#include "dem/scene/expected_impact.hpp"

namespace fiberchain::compare {
namespace {

using dem::NamedRow;

const std::vector<std::string> kColumns = {
    "scene_kind",    "fibers",         "spheres",     "bonds",       "time_step",       "step_from",
    "impact_speed",  "impact_overlap", "steps",       "steps_most",  "step_cost",       "step_cost_from",
    "expected_time", "memory",         "memory_free", "frames",      "trajectory_size", "checkpoint_size",
    "log_size",      "vtk_size",       "branches",    "loss_ripple", "relaxed_modulus", "branch_memory"};

/// A step of a bond in a chain alone, leapfrog, AVX-512: the figure of the README in the plane and in space
/// [s].
constexpr double kPlanarBondStep = 13e-9, kSpatialBondStep = 37e-9;

/// Memory available [bytes]; missing where the system does not say.
dem::Cell free_memory() {
  const auto free = dem::available_memory();
  return free ? dem::Cell(free->bytes) : dem::Cell(dem::Missing{});
}

/// Steps of one fiber, as far as they are known beforehand.
struct FiberSteps {
  std::optional<double> step;  ///< [s]
  std::string from;
  std::optional<double> steps, most;
  bool explicit_steps = true;  ///< of a leapfrog, whose cost is stated
};

/// Memory of one fiber [bytes]: state, and the block-tridiagonal matrix of Newton's method with its factors;
/// with hydrodynamic interactions the dense mobility and its factors, `coupled` unknowns a sphere.
double fiber_memory(const dem::Fiber& fiber, dem::Dimension dimension, int coupled) {
  const double spheres = fiber.aspect_ratio + 1, unknowns = dimension == dem::Dimension::planar ? 3 : 6;
  const double blocks = 2 * 3 * unknowns * unknowns + 8 * unknowns,
               dense = 2 * std::pow(coupled * spheres, 2);
  return sizeof(double) * (blocks * spheres + dense);
}

template <class Scene>
dem::Table fiber_table(const char* kind, const Scene& scene, const FiberSteps& steps, int coupled = 0,
                       const NamedRow& more = {}) {
  const dem::Fiber& fiber = scene.fiber;
  const std::int64_t bonds = fiber.aspect_ratio;
  NamedRow row = {{"scene_kind", std::string(kind)},
                  {"fibers", std::int64_t{1}},
                  {"spheres", bonds + 1},
                  {"bonds", bonds},
                  {"step_from", steps.from},
                  {"memory", fiber_memory(fiber, scene.dimension, coupled)},
                  {"memory_free", free_memory()}};
  if (steps.step) row.emplace_back("time_step", *steps.step);
  if (steps.steps) row.emplace_back("steps", std::llround(*steps.steps));
  if (steps.most) row.emplace_back("steps_most", std::llround(*steps.most));
  if (steps.step && steps.steps && steps.explicit_steps) {
    const double bond_step = scene.dimension == dem::Dimension::planar ? kPlanarBondStep : kSpatialBondStep;
    row.emplace_back("step_cost", bond_step);
    row.emplace_back("step_cost_from", std::string("stated: leapfrog of a chain alone, AVX-512"));
    row.emplace_back("expected_time", bond_step * static_cast<double>(bonds) * *steps.steps);
  }
  dem::Table table(kColumns);
  table.append(joined(row, more));
  return table;
}

dem::Table check(const dem::CantileverScene& scene, int) {
  if (scene.method == dem::Method::solve)
    return fiber_table("cantilever", scene, {{}, "no time: Newton's method", {}, {}});
  const double step = dem::chosen_step(scene.fiber, scene.march);
  const double period = 2 * std::numbers::pi / dem::first_bending_frequency(scene.fiber);
  const double most = (scene.march.ramp_periods + scene.march.max_periods) * period / step;
  return fiber_table("cantilever", scene,
                     {step, scene.march.step_ratio ? "scene" : "0.8 of the stable step", {}, most});
}

dem::Table check(const dem::RodScene& scene, int) {
  return fiber_table("rod", scene, {{}, "no time: Newton's method", {}, {}});
}

dem::Table check(const dem::ReleaseScene& scene, int) {
  const ReleasePlan plan = plan_release(scene);
  const std::string integrator(name(plan.integrator));
  if (plan.integrator == dem::Integrator::cvode) {
    return fiber_table("release", scene, {{}, "control of the error: cvode", {}, {}});
  }
  const std::string reason = plan.reason.empty() ? "stable step and sample interval" : plan.reason;
  const std::string from = fmt::format("{}: {}", integrator, scene.motion.step_ratio ? "scene" : reason);
  const bool leapfrog = plan.integrator != dem::Integrator::implicit;
  return fiber_table("release", scene, {plan.time_step, from, plan.steps, {}, leapfrog}, 0,
                     damping_cells(scene.fiber, scene.damping, scene.motion.form, scene.dimension));
}

template <int Dim>
FiberSteps leapfrog_steps(const dem::FlowScene& scene) {
  const dem::FlowCase<Dim> flow{
      dem::straight_chain<Dim>(scene.fiber), start_poses<Dim>(scene.fiber, scene.start), scene.fluid, {}};
  std::vector<double> times(static_cast<std::size_t>(scene.samples) + 1);
  for (int n = 0; n <= scene.samples; ++n)
    times[static_cast<std::size_t>(n)] = scene.duration * n / scene.samples;
  const dem::FlowPlan plan = dem::plan_of(flow, times, scene.motion);
  const double steps = std::accumulate(plan.counts.begin(), plan.counts.end(), 0.0);
  return {scene.duration / steps,
          scene.motion.step_ratio                            ? "scene"
          : scene.motion.method == dem::FlowMethod::leapfrog ? "0.8 of the stable step"
                                                             : "turning, tension and bending",
          steps,
          {}};
}

dem::Table check(const dem::FlowScene& scene, int) {
  const bool planar = scene.dimension == dem::Dimension::planar;
  if (dem::is_leapfrog(scene.motion.method)) {
    return fiber_table("flow", scene, planar ? leapfrog_steps<2>(scene) : leapfrog_steps<3>(scene));
  }
  const bool coupled = scene.fluid.hydrodynamics != dem::Hydrodynamics::free_draining;
  const bool stresslets = scene.fluid.hydrodynamics == dem::Hydrodynamics::stresslets;
  const FiberSteps steps{{}, fmt::format("control of the error: {}", name(scene.motion.method)), {}, {}};
  return fiber_table("flow", scene, steps, !coupled ? 0 : stresslets ? 11 : 6);
}

std::string step_origin(const dem::StepChoice& choice) {
  if (choice.set_by == "speed" || choice.set_by == "restitution")
    return fmt::format("chosen by {} at {:.3g} m/s", choice.set_by, choice.speed);
  if (choice.set_by == "impacts" || choice.set_by == "bending" || choice.set_by == "turning")
    return fmt::format("chosen by {}, bonds solved within the step", choice.set_by);
  return fmt::format("{} of what is stable: {}", dem::chosen_part, choice.set_by);
}

dem::Table check(const dem::PackingScene& scene, int threads) {
  const dem::PackingPlan plan = dem::plan_of(scene);
  const dem::StepCost cost = dem::measure_step_cost(scene, plan.step, threads);
  const dem::PackingFileSizes files = dem::file_sizes_of(scene, plan.steps);
  const std::int64_t fibers = dem::fibers_in(scene), spheres = dem::spheres_in(scene);
  NamedRow branches;
  for (const dem::PackingFiberKind& kind : scene.kinds) {  // the kind that has the most
    const NamedRow own = damping_cells(kind.fiber, kind.damping, scene.form, dem::Dimension::spatial);
    if (!own.empty() &&
        (branches.empty() || std::get<double>(own.back().second) > std::get<double>(branches.back().second)))
      branches = own;
  }
  dem::Table table(kColumns);
  const NamedRow row = {{"scene_kind", std::string("packing")},
                        {"fibers", fibers},
                        {"spheres", spheres},
                        {"bonds", spheres - fibers},
                        {"time_step", plan.step},
                        {"step_from", scene.step ? std::string("scene") : step_origin(plan.choice)},
                        {"impact_speed", plan.choice.speed},
                        {"impact_overlap", dem::expected_impact_overlap(scene, plan.choice.speed)},
                        {"steps", plan.steps},
                        {"step_cost", cost.per_sphere},
                        {"step_cost_from", fmt::format("measured on {} spheres in a dense stack, threads: {}",
                                                       cost.spheres, cost.threads)},
                        {"expected_time", cost.per_sphere * dem::sphere_steps_of(scene, plan)},
                        {"memory", dem::peak(dem::memory_of(scene))},
                        {"memory_free", free_memory()},
                        {"frames", std::min<std::int64_t>(scene.output.frames, plan.steps) + 1},
                        {"trajectory_size", files.trajectory},
                        {"checkpoint_size", files.checkpoints},
                        {"log_size", files.log},
                        {"vtk_size", files.vtk}};
  table.append(joined(row, branches));
  return table;
}

}  // namespace

dem::Scene scene_to_check(const dem::SceneText& text) {
  dem::Scene scene = dem::parse_scene(text);
  if (auto* packing = std::get_if<dem::PackingScene>(&scene)) *packing = dem::with_start_file(text, *packing);
  return scene;
}

dem::Table scene_check_table(const dem::Scene& scene, int threads) {
  return std::visit([&](const auto& one) { return check(one, threads); }, scene);
}

}  // namespace fiberchain::compare
