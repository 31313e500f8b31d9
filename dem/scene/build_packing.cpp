#include "dem/scene/build_packing.hpp"

#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <utility>

#include "dem/chain/arc_chain.hpp"
#include "dem/files/sha256.hpp"
#include "dem/mesh/mesh_shape.hpp"
#include "dem/model/errors.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/scene/check_starts.hpp"
#include "dem/scene/expected_speed.hpp"

namespace fiberchain::dem {
namespace {

/// Fibers of a kind that come before batch `n`, beside those that were there already.
std::int64_t before_batch(const PackingFiberKind& kind, const Batches& batches, int n) {
  return n <= batches.done ? 0 : kind.count * (n - batches.done) / (batches.number - batches.done);
}

std::int64_t carried_in(const PackingScene& scene) {
  std::int64_t fibers = 0;
  for (const CarriedFibers& group : scene.carried) fibers += group.fibers;
  return fibers;
}

std::int64_t count_in_batch(const PackingScene& scene, const PackingFiberKind& kind, int n) {
  return before_batch(kind, scene.batches, n + 1) - before_batch(kind, scene.batches, n);
}

std::vector<FiberGroup> groups_of_files(const PackingScene& scene) {
  std::vector<FiberGroup> groups;
  for (const PackingFiberKind& kind : scene.kinds) {
    if (kind.starts.empty()) continue;
    FiberGroup group{chain_of(kind), {}};
    for (const FiberStart& start : kind.starts) group.fibers.push_back(placed(group.chain, start));
    groups.push_back(std::move(group));
  }
  return groups;
}

/// As if all kinds were there from the start: the step stays when batches come.
StepChoice step_choice(const PackingScene& scene, Integrator integrator) {
  std::vector<FiberGroup> kinds;
  for (const PackingFiberKind& kind : scene.kinds) kinds.push_back({chain_of(kind), {}});
  AssemblyOptions options;
  options.integrator = integrator;
  options.speed = expected_speed(scene);
  options.restitution_error = scene.restitution_error;
  StepChoice choice = assembly_time_step(kinds, scene.domain, options);
  if (scene.step)
    choice.restitution_error = restitution_error(kinds, scene.domain, choice.speed, *scene.step);
  return choice;
}

}  // namespace

Chain<3> chain_of(const PackingFiberKind& kind) {
  Chain<3> chain = arc_chain(kind.fiber);
  chain.surface = kind.surface;
  chain.smooth = kind.smooth;
  return chain;
}

namespace {

std::int64_t steps_in(const PackingScene& scene, const PackingPlan& plan) {
  constexpr double shortest = 1e-13, longest = 1e3;  // of any fibers [s]
  const double steps = std::ceil(scene.duration / plan.step * (1 - 1e-12));
  if (steps >= 1 && steps < 1e12) return static_cast<std::int64_t>(steps);
  const bool odd_step = !(plan.step >= shortest && plan.step <= longest);
  const std::string how = fmt::format("{:.3g} steps of {:.3g} s", steps, plan.step);
  if (!odd_step || scene.step) {
    throw InvalidKey("duration",
                     fmt::format("duration = {} s is not allowed: it takes {}", scene.duration, how));
  }
  throw InvalidKey(
      "duration",
      fmt::format("the duration of {} s would take {}, a step set by {}{}; allowed: less than 1e12 "
                  "steps; look at youngs_modulus, density, diameter and damping of fibers and walls, "
                  "at gravity and speeds",
                  scene.duration, how, plan.choice.set_by,
                  plan.choice.speed > 0 ? fmt::format(" at {:.3g} m/s", plan.choice.speed) : ""));
}

/// A batch after the end, or within a step of another, would never come.
void check_batches(const PackingScene& scene, double step, std::int64_t steps) {
  for (int n = std::max(1, scene.batches.done + 1); n < scene.batches.number; ++n) {
    const std::int64_t at = batch_step(scene, n, step);
    if (at > batch_step(scene, n - 1, step) && at < steps) continue;
    throw InvalidKey("batches.interval",
                     fmt::format("batches.interval = {:g} s is not allowed: batch {} would come at step {} "
                                 "of {} of {:.4g} s each; "
                                 "each must come at a later one than that before, and before the end",
                                 scene.batches.interval, n + 1, at, steps, step));
  }
}

/// The integrator asked for, or the one whose steps cost less for the time they cover.
PackingPlan with_integrator(const PackingScene& scene) {
  if (scene.integrator != Integrator::automatic)
    return {step_choice(scene, scene.integrator), 0, scene.steps, scene.integrator};
  const bool rolls = std::ranges::any_of(
      scene.kinds, [](const PackingFiberKind& kind) { return kind.fiber.rolling_friction > 0; });
  PackingPlan plain{step_choice(scene, Integrator::leapfrog), 0, scene.steps, Integrator::leapfrog};
  if (rolls) {
    plain.choice.integrator_reason = "rolling friction of the bonds is built for it";
    return plain;
  }
  PackingPlan stiff{step_choice(scene, Integrator::leapfrog_stiff), 0, scene.steps,
                    Integrator::leapfrog_stiff};
  const double longer = stiff.choice.step / plain.choice.step;
  const bool taken = scene.step ? *scene.step > largest_bond_step(plain.choice) : longer > stiff_step_cost;
  PackingPlan plan = taken ? stiff : plain;
  plan.choice.integrator_reason =
      scene.step ? fmt::format("the step given is {} what explicit bonds bear, {:.4g} s",
                               taken ? "beyond" : "within", largest_bond_step(plain.choice))
                 : fmt::format("steps of leapfrog-stiff are {:.3g} times as long and cost {:g} times as much",
                               longer, stiff_step_cost);
  return plan;
}

/// Bonds refuse a step beyond their limits themselves; contacts have theirs where they are pressed.
void check_step(const PackingScene& scene, const StepChoice& choice) {
  if (scene.allow_unstable || !scene.step || *scene.step <= choice.contacts) return;
  throw InvalidKey("motion.step",
                   fmt::format("motion.step = {:g} s is not allowed: contacts are stable up to {:.4g} s; "
                               "motion.allow_unstable: true marches all "
                               "the same",
                               *scene.step, choice.contacts));
}

}  // namespace

int useful_threads(const PackingScene& scene, int threads) {
  constexpr std::int64_t spheres_a_thread = 5000;
  return static_cast<int>(std::clamp<std::int64_t>(spheres_in(scene) / spheres_a_thread, 1, threads));
}

PackingPlan plan_of(const PackingScene& scene) {
  PackingPlan plan = with_integrator(scene);
  check_step(scene, plan.choice);
  plan.step = scene.step.value_or(plan.choice.step);
  if (plan.steps == 0) plan.steps = steps_in(scene, plan);
  check_batches(scene, plan.step, plan.steps);
  return plan;
}

PackingStart packing_start(const PackingScene& scene, int threads, const InsertionWatch& watch,
                           const CarriedStart& carried) {
  const PackingPlan plan = plan_of(scene);
  check_starts(scene);
  PackingStart start{carried.groups, scene.domain, {}, plan.choice, plan.steps};
  for (FiberGroup& group : groups_of_files(scene)) start.groups.push_back(std::move(group));
  const PlacedSpheres there = spheres_of(start.groups);
  for (FiberGroup& group : packing_batch(scene, 0, carried.time, there, watch)) {
    start.groups.push_back(std::move(group));
  }
  start.options = {.step = plan.step,
                   .integrator = plan.integrator,
                   .form = scene.form,
                   .rolling = scene.rolling,
                   .threads = useful_threads(scene, threads),
                   .account_energy = scene.account_energy,
                   .orientations = scene.orientations};
  start.options.grips = grips_of(scene);
  if (!carried.groups.empty()) {
    start.options.steps_before = std::llround(carried.time / plan.step);
    start.options.time_shift = carried.time - static_cast<double>(start.options.steps_before) * plan.step;
  }
  return start;
}

Assembly make_assembly(PackingStart start) {
  Assembly assembly(std::move(start.groups), std::move(start.domain), std::move(start.options));
#ifdef __GLIBC__
  malloc_trim(0);  // the states that fibers started from took as much as a third of what the run needs
#endif
  return assembly;
}

std::int64_t batch_step(const PackingScene& scene, int n, double step) {
  return std::llround(n * scene.batches.interval / step);
}

std::vector<InsertionCount> batch_counts(const PackingScene& scene, int n) {
  std::vector<InsertionCount> counts;
  for (const PackingFiberKind& kind : scene.kinds) {
    const std::int64_t count = count_in_batch(scene, kind, n);
    if (count > 0) counts.push_back({chain_of(kind), count});
  }
  return counts;
}

int groups_at_start(const PackingScene& scene) {
  const auto of_files =
      std::ranges::count_if(scene.kinds, [](const PackingFiberKind& k) { return !k.starts.empty(); });
  return static_cast<int>(std::ssize(scene.carried) + of_files + std::ssize(batch_counts(scene, 0)));
}

std::vector<std::int64_t> kinds_of_groups(const PackingScene& scene,
                                          const std::vector<std::int64_t>& inserted) {
  std::vector<std::int64_t> kinds;
  for (const CarriedFibers& group : scene.carried) kinds.push_back(group.kind);
  const std::int64_t all = std::ssize(scene.kinds);
  for (std::int64_t k = 0; k < all; ++k) {
    if (!scene.kinds[k].starts.empty()) kinds.push_back(k);
  }
  std::size_t later = 0;
  for (int n = 0; n < scene.batches.number; ++n) {
    for (std::int64_t k = 0; k < all; ++k) {
      if (count_in_batch(scene, scene.kinds[k], n) == 0) continue;
      if (n > 0 && later == inserted.size()) return kinds;
      if (n == 0 || inserted[later++] > 0) kinds.push_back(k);
    }
  }
  return kinds;
}

std::vector<Grip> grips_of(const PackingScene& scene) {
  std::vector<std::int64_t> counts;  // of each group at the start
  for (const CarriedFibers& group : scene.carried) counts.push_back(group.fibers);
  for (const PackingFiberKind& kind : scene.kinds) {
    if (!kind.starts.empty()) counts.push_back(std::ssize(kind.starts));
  }
  for (const InsertionCount& group : batch_counts(scene, 0)) counts.push_back(group.count);
  const std::vector<std::int64_t> kinds = kinds_of_groups(scene, {});
  std::vector<Grip> grips;
  int holds = 0, loads = 0;
  for (const SceneGrip& held : scene.held) {
    const std::string key =
        held.is_load ? fmt::format("loads[{}].fiber", loads++) : fmt::format("held[{}].fiber", holds++);
    Grip grip = held.grip;
    std::int64_t before = 0;  // fibers of the kind in earlier groups
    for (std::size_t g = 0; g < counts.size(); ++g) {
      if (kinds[g] != static_cast<std::int64_t>(held.kind)) continue;
      for (std::int64_t f = 0; f < counts[g]; ++f) {
        if (held.fiber && before + f != *held.fiber) continue;
        for (const int sphere : held.spheres)
          grip.spheres.push_back({static_cast<int>(g), static_cast<int>(f), sphere});
      }
      before += counts[g];
    }
    if (grip.spheres.empty()) {
      throw InvalidKey(key, held.fiber
                                ? fmt::format("{} is not allowed: {} fibers of this kind are there at the "
                                              "start, from 0 on",
                                              *held.fiber, before)
                                : "no fibers of this kind are there at the start");
    }
    grips.push_back(std::move(grip));
  }
  return grips;
}

namespace {

/// Least gap of spheres beyond which smooth fibers do not overlap: l/2 from both middles of crossed segments,
/// their spheres are sqrt(d^2 + l^2/2) apart.
double gap_of_segments(const PackingScene& scene) {
  double gap = 0;
  for (const PackingFiberKind& kind : scene.kinds) {
    const double d = kind.fiber.diameter, l = bond_length(kind.fiber);
    if (kind.smooth) gap = std::max(gap, std::sqrt(d * d + l * l / 2) - d);
  }
  return gap;
}

}  // namespace

std::vector<FiberGroup> packing_batch(const PackingScene& scene, int n, double time,
                                      const PlacedSpheres& present, const InsertionWatch& watch,
                                      Shortfall shortfall) {
  const std::vector<InsertionCount> counts = batch_counts(scene, n);
  if (counts.empty()) return {};
  InsertionRules rules = scene.filling;
  rules.gap += gap_of_segments(scene);
  rules.time = time;
  rules.first_number = carried_in(scene);
  for (const PackingFiberKind& kind : scene.kinds) rules.first_number += before_batch(kind, scene.batches, n);
  return random_insertion(counts, rules, scene.domain, present, watch, shortfall);
}

std::int64_t fibers_in(const PackingScene& scene) {
  std::int64_t sum = carried_in(scene);
  for (const PackingFiberKind& kind : scene.kinds) {
    sum += kind.count + static_cast<std::int64_t>(kind.starts.size());
  }
  return sum;
}

std::int64_t spheres_in(const PackingScene& scene) {
  std::int64_t sum = 0;
  for (const PackingFiberKind& kind : scene.kinds) {
    sum += (kind.count + static_cast<std::int64_t>(kind.starts.size())) * (kind.fiber.aspect_ratio + 1);
  }
  for (const CarriedFibers& group : scene.carried)
    sum += group.fibers * (scene.kinds[group.kind].fiber.aspect_ratio + 1);
  return sum;
}

namespace {

template <class Value>
std::string_view bytes_of(const std::vector<Value>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

}  // namespace

std::string scene_fingerprint(const SceneText& text, const PackingScene& scene) {
  std::string all = sha256(text.text);
  for (const PackingFiberKind& kind : scene.kinds) {
    if (kind.file) all += sha256(kind.file->text);
    if (kind.material_file) all += sha256(kind.material_file->text);
  }
  for (const Wall& wall : scene.domain.walls) {
    if (const MeshShape* shape = mesh_in(wall)) {
      all += sha256(bytes_of(shape->mesh->vertices)) + sha256(bytes_of(shape->mesh->triangles));
    }
    if (!wall.motion.course) continue;
    const WallCourse& course = *wall.motion.course;
    for (const auto* values : {&course.place.time, &course.place.value, &course.angle.value})
      all += sha256(fmt::format("{}", fmt::join(*values, ",")));
  }
  return sha256(all);
}

}  // namespace fiberchain::dem
