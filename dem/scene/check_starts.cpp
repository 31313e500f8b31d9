#include "dem/scene/check_starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
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

/// Places along a fiber between whose spheres of its radius no other finds room, and the sphere at each or
/// before it: its own spheres, of a smooth one more between them.
struct FiberPlaces {
  std::vector<Vec<double, 3>> position;
  std::vector<std::size_t> sphere;
};

FiberPlaces places_along(const PackingFiberKind& kind, std::span<const Vec<double, 3>> spheres) {
  const double R = sphere_radius(kind.fiber);
  const int parts = kind.smooth ? static_cast<int>(std::ceil(bond_length(kind.fiber) / R)) : 1;
  FiberPlaces places;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const bool is_last = i + 1 == spheres.size();
    for (int k = 0; k < (is_last ? 1 : parts); ++k) {
      const Vec<double, 3> on = is_last ? Vec<double, 3>{} : spheres[i + 1] - spheres[i];
      places.position.push_back(spheres[i] + (static_cast<double>(k) / parts) * on);
      places.sphere.push_back(i);
    }
  }
  return places;
}

void check_walls(const PackingScene& scene, const PackingFiberKind& kind, std::size_t fiber,
                 std::span<const Vec<double, 3>> spheres) {
  const double radius = sphere_radius(kind.fiber);
  const FiberPlaces places = places_along(kind, spheres);
  for (std::size_t k = 0; k < places.position.size(); ++k) {
    const std::size_t i = places.sphere[k];
    for (std::size_t w = 0; w < scene.domain.walls.size(); ++w) {
      const Wall& at = scene.domain.walls[w];
      const double gap = distance_to(at, places.position[k], 0);
      const bool own = k == 0 || places.sphere[k - 1] != i;
      if (own && i > 0 && is_active(at, 0) && passes_through(at, spheres[i - 1], spheres[i], 0)) {
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

/// All fibers, in the order of kinds: each against those before it, of spheres also against itself.
void check_others(const PackingScene& scene, const PlacedSpheres& all) {
  const auto [least, largest] = std::ranges::minmax(all.radius);
  InsertionGrid before(box_around(all.position), scene.domain.period, largest, -refused_from * least,
                       std::ssize(all.radius));
  std::size_t n = 0;
  for (const PackingFiberKind& kind : scene.kinds) {
    const double R = sphere_radius(kind.fiber);
    const std::size_t count = static_cast<std::size_t>(kind.fiber.aspect_ratio) + 1;
    for (std::size_t f = 0; f < kind.starts.size(); ++f, n += count) {
      const FiberPlaces places = places_along(kind, std::span(all.position).subspan(n, count));
      for (std::size_t k = 0; k < places.position.size(); ++k) {
        if (!before.free(places.position[k], R)) {
          throw InvalidInput(fmt::format("{}it lies in another one by half a radius or more",
                                         sphere_of(kind, f, places.sphere[k])));
        }
        if (!kind.smooth) before.add(places.position[k], R);
      }
      if (!kind.smooth) continue;
      for (const Vec<double, 3>& place : places.position) before.add(place, R);
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
      const std::size_t first = all.position.size();
      for (const auto& pose : poses) all.position.push_back(pose.position);
      check_walls(scene, kind, f, std::span(all.position).subspan(first));
    }
    all.radius.resize(all.position.size(), sphere_radius(kind.fiber));
  }
  if (!all.radius.empty()) check_others(scene, all);
}

}  // namespace fiberchain::dem
