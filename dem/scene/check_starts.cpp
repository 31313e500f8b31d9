#include "dem/scene/check_starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "dem/insertion/insertion_grid.hpp"
#include "dem/insertion/random_insertion.hpp"
#include "dem/mesh/mesh_shape.hpp"
#include "dem/model/errors.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/fiber_csv.hpp"

namespace fiberchain::dem {
namespace {

/// Half a radius typed as such is half a radius.
constexpr double refused_from = deepest_start * (1 - 1e-9);

std::string sphere_of(const PackingFiberKind& kind, std::size_t fiber, std::size_t sphere) {
  const std::string file =
      kind.file ? fmt::format("{}:{}: ", kind.file->name, line_of_start(kind.file->text, fiber)) : "";
  return fmt::format("{}sphere {} of fiber {} is not allowed there: ", file, sphere, fiber);
}

std::string wall_in_words(std::size_t number) {
  return fmt::format(
      "wall {} (walls of the box first, then planes, cylinders, spheres, obstacles, cones, meshes)",
      number + 1);
}

void check_walls(const PackingScene& scene, const PackingFiberKind& kind, std::size_t fiber,
                 const Poses<3>& poses) {
  const double radius = sphere_radius(kind.fiber);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t w = 0; w < scene.domain.walls.size(); ++w) {
      const Wall& at = scene.domain.walls[w];
      const double gap = distance_to(at, poses[i].position, 0);
      if (i > 0 && is_active(at, 0) && passes_through(at, poses[i - 1].position, poses[i].position, 0)) {
        throw InvalidInput(fmt::format("{}the fiber goes through {} between it and the sphere before",
                                       sphere_of(kind, fiber, i), wall_in_words(w)));
      }
      if (radius - gap < refused_from * radius) continue;
      const std::string wall = wall_in_words(w);
      if (gap <= 0) {
        throw InvalidInput(
            fmt::format("{}its center is {:.4g} m behind {}", sphere_of(kind, fiber, i), -gap, wall));
      }
      throw InvalidInput(
          fmt::format("{}it lies in {} by {:.4g} m; allowed: less than half its radius, {:.4g} m",
                      sphere_of(kind, fiber, i), wall, radius - gap, deepest_start * radius));
    }
  }
}

/// All spheres, in the order of kinds, fibers and spheres.
void check_others(const PackingScene& scene, const PlacedSpheres& all) {
  const auto [least, largest] = std::ranges::minmax(all.radius);
  InsertionGrid before(box_around(all.position), scene.domain.period, largest, -refused_from * least,
                       std::ssize(all.radius));
  std::size_t n = 0;
  for (const PackingFiberKind& kind : scene.kinds) {
    for (std::size_t f = 0; f < kind.starts.size(); ++f) {
      for (std::size_t i = 0; i <= static_cast<std::size_t>(kind.fiber.aspect_ratio); ++i, ++n) {
        if (!before.free(all.position[n], all.radius[n])) {
          throw InvalidInput(
              fmt::format("{}it lies in another one by half a radius or more", sphere_of(kind, f, i)));
        }
        before.add(all.position[n], all.radius[n]);
      }
    }
  }
}

}  // namespace

void check_starts(const PackingScene& scene) {
  PlacedSpheres all;
  for (const PackingFiberKind& kind : scene.kinds) {
    const Chain<3> chain = chain_of(kind);
    for (std::size_t f = 0; f < kind.starts.size(); ++f) {
      const Poses<3> poses = placed(chain, kind.starts[f]).poses;
      check_walls(scene, kind, f, poses);
      for (const auto& pose : poses) all.position.push_back(pose.position);
    }
    all.radius.resize(all.position.size(), sphere_radius(kind.fiber));
  }
  if (!all.radius.empty()) check_others(scene, all);
}

}  // namespace fiberchain::dem
