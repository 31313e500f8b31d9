#include "dem/io/packing_setup.hpp"

#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <utility>

#include "dem/arc_chain.hpp"
#include "dem/errors.hpp"
#include "dem/io/sha256.hpp"

namespace fiberchain::dem::io {
namespace {

/// Fibers of a kind that come before batch `n`.
std::int64_t before_batch(const FiberKind& kind, const Batches& batches, int n) {
  return kind.count * n / batches.number;
}

std::vector<FiberGroup> groups_of_files(const PackingScene& scene) {
  std::vector<FiberGroup> groups;
  for (const FiberKind& kind : scene.kinds) {
    if (kind.starts.empty()) continue;
    FiberGroup group{chain_of(kind), {}};
    for (const FiberStart& start : kind.starts) group.fibers.push_back(placed(group.chain, start));
    groups.push_back(std::move(group));
  }
  return groups;
}

/// As if all kinds were there from the start: the step stays when batches come.
StepChoice step_choice(const PackingScene& scene) {
  std::vector<FiberGroup> kinds;
  for (const FiberKind& kind : scene.kinds) kinds.push_back({chain_of(kind), {}});
  return assembly_time_step(kinds, scene.surroundings);
}

}  // namespace

Chain<3> chain_of(const FiberKind& kind) { return arc_chain(kind.fiber, kind.bend); }

namespace {

/// Threads that are worth waiting for each other every step.
int useful_threads(const PackingScene& scene, int threads) {
  constexpr std::int64_t spheres_a_thread = 5000;
  return static_cast<int>(std::clamp<std::int64_t>(spheres_in(scene) / spheres_a_thread, 1, threads));
}

}  // namespace

PackingStart packing_start(const PackingScene& scene, int threads) {
  PackingStart start{groups_of_files(scene), scene.surroundings, {}, step_choice(scene), scene.steps};
  for (FiberGroup& group : packing_batch(scene, 0, spheres_of(start.groups))) {
    start.groups.push_back(std::move(group));
  }
  const double step = scene.step.value_or(start.choice.step);
  start.options = {.step = step,
                   .form = scene.form,
                   .rolling = scene.rolling,
                   .threads = useful_threads(scene, threads),
                   .book_energy = scene.book_energy,
                   .orientations = scene.orientations};
  if (start.steps > 0) return start;
  const double steps = std::ceil(scene.duration / step * (1 - 1e-12));
  if (!(steps >= 1 && steps < 1e12)) {
    throw InvalidInput(fmt::format("duration = {} s is not allowed: it takes {:.3g} steps of {:.3g} s",
                                   scene.duration, steps, step));
  }
  start.steps = static_cast<std::int64_t>(steps);
  return start;
}

Assembly make_assembly(PackingStart start) {
  Assembly assembly(std::move(start.groups), std::move(start.surroundings), std::move(start.options));
#ifdef __GLIBC__
  malloc_trim(0);  // the states that fibers started from took as much as a third of what the run needs
#endif
  return assembly;
}

std::int64_t batch_step(const PackingScene& scene, int n, double step) {
  return std::llround(n * scene.batches.interval / step);
}

std::vector<FillCount> batch_counts(const PackingScene& scene, int n) {
  std::vector<FillCount> counts;
  for (const FiberKind& kind : scene.kinds) {
    const std::int64_t count =
        before_batch(kind, scene.batches, n + 1) - before_batch(kind, scene.batches, n);
    if (count > 0) counts.push_back({chain_of(kind), count});
  }
  return counts;
}

int groups_at_start(const PackingScene& scene) {
  const auto of_files =
      std::ranges::count_if(scene.kinds, [](const FiberKind& k) { return !k.starts.empty(); });
  return static_cast<int>(of_files) + static_cast<int>(batch_counts(scene, 0).size());
}

std::vector<FiberGroup> packing_batch(const PackingScene& scene, int n, const PlacedSpheres& present) {
  const std::vector<FillCount> counts = batch_counts(scene, n);
  if (counts.empty()) return {};
  FillRules rules = scene.filling;
  rules.time = n * scene.batches.interval;
  rules.first_number = 0;
  for (const FiberKind& kind : scene.kinds) rules.first_number += before_batch(kind, scene.batches, n);
  return fill(counts, rules, scene.surroundings, present);
}

std::int64_t fibers_in(const PackingScene& scene) {
  std::int64_t sum = 0;
  for (const FiberKind& kind : scene.kinds) {
    sum += kind.count + static_cast<std::int64_t>(kind.starts.size());
  }
  return sum;
}

std::int64_t spheres_in(const PackingScene& scene) {
  std::int64_t sum = 0;
  for (const FiberKind& kind : scene.kinds) {
    sum += (kind.count + static_cast<std::int64_t>(kind.starts.size())) * (kind.fiber.aspect_ratio + 1);
  }
  return sum;
}

std::string scene_fingerprint(const SceneText& text, const PackingScene& scene) {
  std::string all = sha256(text.text);
  for (const FiberKind& kind : scene.kinds) {
    if (kind.file) all += sha256(kind.file->text);
  }
  return sha256(all);
}

}  // namespace fiberchain::dem::io
