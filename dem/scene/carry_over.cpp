#include "dem/scene/carry_over.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem/model/invalid_key.hpp"
#include "dem/scene/build_packing.hpp"

namespace fiberchain::dem {
namespace {

constexpr double same_radius = 1e-6;  // relative: a trajectory may have rounded it

bool fits(const PackingFiberKind& kind, const CarriedGroup& group) {
  const double radius = sphere_radius(kind.fiber);
  return kind.fiber.aspect_ratio + 1 == group.spheres() &&
         std::abs(group.radius - radius) <= same_radius * radius;
}

std::string key_of_kind(std::int64_t kind, const char* key) {
  return fmt::format("fibers[{}].{}", kind, key);
}

/// Length of a group's first fiber from sphere to sphere [m].
double first_length(const CarriedGroup& group) {
  double length = 0;
  const auto& poses = group.fibers.front().poses;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i)
    length += norm(poses[i + 1].position - poses[i].position);
  return length;
}

void check_shape(const PackingScene& scene, std::int64_t kind, const CarriedGroup& group) {
  if (kind < 0 || kind >= std::ssize(scene.kinds)) {
    throw InvalidKey("fibers", fmt::format("has {} kinds; the fibers of start_from are of {} at least",
                                           scene.kinds.size(), kind + 1));
  }
  const Fiber& fiber = scene.kinds[kind].fiber;
  if (fiber.aspect_ratio + 1 != group.spheres()) {
    throw InvalidKey(
        key_of_kind(kind, "aspect_ratio"),
        fmt::format("aspect_ratio = {} is not allowed: the fibers of start_from have {} spheres, "
                    "an aspect ratio of {}",
                    fiber.aspect_ratio, group.spheres(), group.spheres() - 1));
  }
  if (!fits(scene.kinds[kind], group)) {
    throw InvalidKey(key_of_kind(kind, "diameter"),
                     fmt::format("diameter = {} m is not allowed: the fibers of start_from have {} m",
                                 fiber.diameter, 2 * group.radius));
  }
  constexpr double most_drawn = 0.2;  // a rod's linear laws end before
  const double drawn = group.fibers.empty() ? 1 : first_length(group) / fiber_length(fiber);
  if (std::abs(drawn - 1) > most_drawn) {
    throw InvalidKey(
        key_of_kind(kind, "spacing"),
        fmt::format("spacing = {:g} is not allowed: the bonds of start_from are {:.3g} times as long",
                    fiber.spacing, drawn));
  }
  const bool unknown = !group.oriented && (group.histories.empty() || group.form != scene.form);
  if (unknown && fiber.rest_angle != 0) {
    throw InvalidKey(
        key_of_kind(kind, "curvature"),
        "curvature is not allowed: the file of start_from does not say how fibers are turned about "
        "their axes; a checkpoint does, of the same motion.form or with motion.orientations");
  }
}

/// Batches that are over where a clock goes on from `time`; the last one stays, if only to bring at once what
/// is missing.
int batches_done(const PackingScene& scene, double time) {
  if (scene.start_from && scene.start_from->clock == StartClock::zero) return 0;
  int next = 1;
  while (next < scene.batches.number && next * scene.batches.interval <= time) ++next;
  return std::min(next, scene.batches.number - 1);
}

double fastest_in(const CarriedState& state) {
  double fastest = 0;
  for (const CarriedGroup& group : state.groups) {
    for (const ChainState<3>& fiber : group.fibers) {
      for (const auto& v : fiber.velocity) fastest = std::max(fastest, norm(v));
    }
  }
  return fastest;
}

/// Takes what is there off what is to come.
void take_off(PackingScene& scene, std::int64_t k, std::int64_t there) {
  PackingFiberKind& kind = scene.kinds[k];
  if (there == 0) return;
  const char* key = kind.file ? "starts" : "count";
  const std::int64_t wanted = kind.file ? std::ssize(kind.starts) : kind.count;
  if (wanted < there || (kind.file && wanted != there)) {
    throw InvalidKey(key_of_kind(k, key),
                     fmt::format("{} = {} fibers is not allowed: start_from has {} of them{}", key, wanted,
                                 there, kind.file ? "" : "; allowed: as many or more"));
  }
  kind.starts.clear();
  kind.count = kind.file ? 0 : wanted - there;
}

}  // namespace

std::vector<std::int64_t> kinds_by_shape(const PackingScene& scene, const CarriedState& state) {
  std::vector<std::int64_t> kinds;
  for (const CarriedGroup& group : state.groups) {
    std::int64_t found = -1;
    for (std::int64_t k = 0; k < std::ssize(scene.kinds); ++k) {
      if (!fits(scene.kinds[k], group)) continue;
      if (found >= 0) {
        throw InvalidKey("start_from",
                         fmt::format("a trajectory does not say which of fibers[{}] and fibers[{}], of "
                                     "the same diameter and aspect ratio, a fiber is of; a checkpoint "
                                     "does",
                                     found, k));
      }
      found = k;
    }
    if (found < 0) {
      throw InvalidKey("fibers",
                       fmt::format("has no kind with the {} spheres of {} m in diameter that fibers of "
                                   "start_from have (aspect_ratio {})",
                                   group.spheres(), 2 * group.radius, group.spheres() - 1));
    }
    kinds.push_back(found);
  }
  return kinds;
}

PackingScene carried_over(PackingScene scene, const CarriedState& state,
                          const std::vector<std::int64_t>& kinds) {
  if (kinds.size() != state.groups.size())
    throw InvalidKey("start_from", "the checkpoint does not say of which kind each of its groups is");
  std::vector<std::int64_t> there(scene.kinds.size(), 0);
  for (std::size_t g = 0; g < kinds.size(); ++g) {
    check_shape(scene, kinds[g], state.groups[g]);
    const std::int64_t fibers = std::ssize(state.groups[g].fibers);
    there[kinds[g]] += fibers;
    scene.carried.push_back({static_cast<int>(kinds[g]), fibers});
  }
  for (std::int64_t k = 0; k < std::ssize(scene.kinds); ++k) take_off(scene, k, there[k]);
  scene.batches.done = batches_done(scene, state.time);
  scene.carried_speed = fastest_in(state);
  return scene;
}

PackingScene carried_over(PackingScene scene, const std::vector<std::int64_t>& pairs, std::int64_t done) {
  std::vector<std::int64_t> there(scene.kinds.size(), 0);
  for (std::size_t n = 0; n + 1 < pairs.size(); n += 2) {
    if (pairs[n] < 0 || pairs[n] >= std::ssize(scene.kinds) || pairs[n + 1] < 1)
      throw InvalidInput("the checkpoint has fibers of a kind that the scene does not have");
    there[pairs[n]] += pairs[n + 1];
    scene.carried.push_back({static_cast<int>(pairs[n]), pairs[n + 1]});
  }
  if (pairs.empty()) return scene;
  for (std::int64_t k = 0; k < std::ssize(scene.kinds); ++k) take_off(scene, k, there[k]);
  scene.batches.done = static_cast<int>(std::clamp<std::int64_t>(done, 0, scene.batches.number - 1));
  return scene;
}

std::vector<std::int64_t> pairs_of(const std::vector<CarriedFibers>& carried) {
  std::vector<std::int64_t> pairs;
  for (const CarriedFibers& group : carried) pairs.insert(pairs.end(), {group.kind, group.fibers});
  return pairs;
}

std::vector<FiberGroup> groups_of(const PackingScene& scene, const CarriedState& state) {
  std::vector<FiberGroup> groups;
  for (std::size_t g = 0; g < state.groups.size(); ++g)
    groups.push_back({chain_of(scene.kinds[scene.carried[g].kind]), state.groups[g].fibers});
  return groups;
}

}  // namespace fiberchain::dem
