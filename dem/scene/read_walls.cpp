#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

/// Mapping "box" as typed.
struct BoxKeys {
  std::array<std::optional<double>, 3> side;  ///< [m]
  bool open = false;
  Wall surface = {.shape = Plane{}};  ///< of all its walls
};

KeyTable<BoxKeys> box_keys() {
  KeyTable<BoxKeys> table;
  for (int a = 0; a < 3; ++a) {
    table
        .quantity(
            kAxes[a], "m", [a](BoxKeys & box) -> auto& { return box.side[a]; }, kPositive,
            std::string("walls across ") + kAxes[a] + " at 0 and here; not where this side is periodic")
        .otherwise(a == 2 ? "required, unless periodic or open" : "required, unless periodic");
  }
  table.choice("lid", &BoxKeys::open, Words<bool>{{"closed", false}, {"open", true}},
               "wall at the top, across z");
  declare_wall_surface(
      table, [](BoxKeys & box) -> auto& { return box.surface; });
  return table;
}

/// A wall around fibers leaves them room: they would be pressed from all sides for good.
void check_width(const StrictMapping& mapping, const char* key, double width, double diameter,
                 double of_width = 1) {
  if (width >= diameter * (1 - 1e-12)) return;
  mapping.fail(key, fmt::format("{:g} m is not allowed: it is narrower than the fibers, {:g} m in diameter; "
                                "allowed: at least {:g} m",
                                of_width * width, diameter, of_width * diameter));
}

Wall wall_across(int axis, double position, double into, const Wall& surface) {
  Plane plane{};
  plane.point[axis] = position;
  plane.normal[axis] = into;
  Wall wall = surface;
  wall.shape = plane;
  return wall;
}

/// Walls at 0 and the length of every side given; no wall at the top of an open box.
void store_box(const StrictMapping& mapping, const BoxKeys& box, PackingScene& scene) {
  for (int a = 0; a < 3; ++a) {
    const bool floor_alone = a == 2 && box.open;
    if (scene.domain.period[a] > 0) {
      if (box.side[a]) mapping.fail(kAxes[a], "has no walls: this side is periodic");
      continue;
    }
    if (!box.side[a] && !floor_alone) mapping.fail_missing(kAxes[a]);
    if (box.side[a]) {
      check_width(mapping, kAxes[a], *box.side[a], largest_diameter(scene));
      scene.scene_box.high[a] = *box.side[a];
    }
    scene.domain.walls.push_back(wall_across(a, 0, 1, box.surface));
    if (!floor_alone) scene.domain.walls.push_back(wall_across(a, scene.scene_box.high[a], -1, box.surface));
  }
}

/// Where fibers are.
const Words<double> kSides{{"inside", 1}, {"outside", -1}};

KeyTable<Wall> plane_keys() {
  KeyTable<Wall> table(Wall{Plane{}});
  const auto plane = [](Wall& wall) -> Plane& { return *wall.shape.get_if<Plane>(); };
  table
      .vector(
          "point", "m", [=](Wall & wall) -> auto& { return plane(wall).point; }, "a point of the wall")
      .required();
  table
      .direction(
          "normal", [=](Wall & wall) -> auto& { return plane(wall).normal; },
          "normal, to the side of the fibers")
      .required();
  declare_wall_motion(table);
  return table;
}

KeyTable<Wall> cylinder_keys() {
  KeyTable<Wall> table(Wall{Cylinder{}});
  const auto cylinder = [](Wall& wall) -> Cylinder& { return *wall.shape.get_if<Cylinder>(); };
  table
      .vector(
          "point", "m", [=](Wall & wall) -> auto& { return cylinder(wall).point; }, "a point of the axis")
      .required();
  table
      .direction(
          "axis", [=](Wall & wall) -> auto& { return cylinder(wall).axis; }, "direction of the axis")
      .required();
  table
      .quantity(
          "radius", "m", [=](Wall & wall) -> auto& { return cylinder(wall).radius; }, kPositive, "radius")
      .required();
  table.choice(
      "fibers", [=](Wall & wall) -> auto& { return cylinder(wall).side; }, kSides, "which side they are on");
  declare_wall_motion(table);
  return table;
}

KeyTable<Wall> sphere_keys() {
  KeyTable<Wall> table(Wall{Sphere{}});
  const auto sphere = [](Wall& wall) -> Sphere& { return *wall.shape.get_if<Sphere>(); };
  table
      .vector(
          "center", "m", [=](Wall & wall) -> auto& { return sphere(wall).point; }, "center")
      .required();
  table
      .quantity(
          "radius", "m", [=](Wall & wall) -> auto& { return sphere(wall).radius; }, kPositive, "radius")
      .required();
  table.choice(
      "fibers", [=](Wall & wall) -> auto& { return sphere(wall).side; }, kSides, "which side they are on");
  declare_wall_motion(table);
  return table;
}

KeyTable<Wall> obstacle_keys() {
  KeyTable<Wall> table(Wall{BoxObstacle{.point = {}, .half = {}, .along = {1, 0, 0}, .across = {0, 1, 0}}});
  const auto box = [](Wall& wall) -> BoxObstacle& { return *wall.shape.get_if<BoxObstacle>(); };
  table
      .vector(
          "center", "m", [=](Wall & wall) -> auto& { return box(wall).point; }, "center")
      .required();
  table
      .vector(
          "sides", "m", [=](Wall & wall) -> auto& { return box(wall).half; }, "lengths of its sides, above 0")
      .required();
  table
      .direction(
          "along", [=](Wall & wall) -> auto& { return box(wall).along; }, "direction of the first side")
      .otherwise("x");
  table
      .direction(
          "across", [=](Wall & wall) -> auto& { return box(wall).across; },
          "direction of the second side; what is along the first is left out")
      .otherwise("y");
  declare_wall_motion(table);
  return table;
}

KeyTable<Wall> cone_keys() {
  KeyTable<Wall> table(Wall{Cone{}});
  const auto cone = [](Wall& wall) -> Cone& { return *wall.shape.get_if<Cone>(); };
  table
      .vector(
          "point", "m", [=](Wall & wall) -> auto& { return cone(wall).point; }, "center of the first rim")
      .required();
  table
      .direction(
          "axis", [=](Wall & wall) -> auto& { return cone(wall).axis; }, "from there to the second rim's")
      .required();
  table
      .quantity(
          "length", "m", [=](Wall & wall) -> auto& { return cone(wall).length; }, kNonNegative,
          "from rim to rim along the axis; 0: a disk or ring")
      .required();
  table
      .quantity(
          "radius", "m", [=](Wall & wall) -> auto& { return cone(wall).radius; }, kNonNegative,
          "radius of the first rim, of the middle of the shell; 0: closed")
      .required();
  table
      .quantity(
          "end_radius", "m", [=](Wall & wall) -> auto& { return cone(wall).end_radius; }, kNonNegative,
          "radius of the second rim; the same: a tube")
      .required();
  table.quantity(
      "thickness", "m", [=](Wall & wall) -> auto& { return cone(wall).half; }, kNonNegative,
      "thickness of the shell, rims rounded");
  declare_wall_motion(table);
  return table;
}

/// Keys that make no box: sides that are none, two of one direction.
void complete_obstacle(const StrictMapping& mapping, BoxObstacle& box) {
  for (int c = 0; c < 3; ++c) {
    if (!(box.half[c] > 0)) mapping.fail("sides", "must all be above 0");
    box.half[c] *= 0.5;
  }
  const Vec<double, 3> across = box.across - dot(box.across, box.along) * box.along;
  if (!(norm(across) > 1e-6)) mapping.fail("across", "must be another direction than along");
  box.across = (1 / norm(across)) * across;
}

void complete_cone(const StrictMapping& mapping, Cone& cone) {
  if (!(cone.radius > 0) && !(cone.end_radius > 0))
    mapping.fail("end_radius", "must be above 0 where radius is 0");
  if (cone.length == 0 && cone.radius == cone.end_radius)
    mapping.fail("length", "must be above 0 where both radii are the same");
  cone.half *= 0.5;
}

/// Stores a wall whose key `along` says how it lies.
auto store_wall(const char* along) {
  return [along](const StrictMapping& mapping, const Wall& wall, PackingScene& scene) {
    if (!(wall.active_from < wall.active_until)) mapping.fail("until", "must be later than from");
    for (int a = 0; a < 3; ++a) {
      if (scene.domain.period[a] > 0 && !is_invariant_along(wall, a)) {
        mapping.fail(
            along, std::string("must leave the wall the same all along ") + kAxes[a] + ", which is periodic");
      }
    }
    const double thickest = largest_diameter(scene);
    if (const auto* tube = wall.shape.get_if<Cylinder>(); tube != nullptr && tube->side > 0)
      check_width(mapping, "radius", 2 * tube->radius, thickest, 0.5);
    if (const auto* ball = wall.shape.get_if<Sphere>(); ball != nullptr && ball->side > 0)
      check_width(mapping, "radius", 2 * ball->radius, thickest, 0.5);
    Wall completed = wall;
    complete_drive(mapping, completed, scene);
    Wall& stored = scene.domain.walls.emplace_back(std::move(completed));
    if (auto* box = stored.shape.get_if<BoxObstacle>()) complete_obstacle(mapping, *box);
    if (auto* cone = stored.shape.get_if<Cone>()) complete_cone(mapping, *cone);
  };
}

void store_mesh_wall(const StrictMapping& mapping, const MeshWallKeys& keys, PackingScene& scene) {
  store_wall("file")(mapping, mesh_wall(mapping, keys), scene);
}

KeyTable<PackingScene> wall_keys() {
  KeyTable<PackingScene> table;
  const auto youngs_modulus = [](PackingScene & scene) -> auto& { return scene.domain.wall_youngs_modulus; };
  const auto poisson_ratio = [](PackingScene & scene) -> auto& { return scene.domain.wall_poisson_ratio; };
  table.quantity("youngs_modulus", "Pa", youngs_modulus, kPositive, "Young's modulus of all walls")
      .otherwise("rigid");
  table.number("poisson_ratio", poisson_ratio, kPoissonRatio, "Poisson's ratio of all walls")
      .only_with("youngs_modulus",
                 [](const PackingScene& scene) { return scene.domain.wall_youngs_modulus > 0; });
  table.mapping("box", box_keys(), &store_box, "walls from 0 to the length of each side").otherwise("none");
  table.list("planes", plane_keys(), store_wall("normal"), "plane walls").otherwise("none");
  table.list("cylinders", cylinder_keys(), store_wall("axis"), "endless cylinders").otherwise("none");
  table.list("spheres", sphere_keys(), store_wall("center"), "spherical walls").otherwise("none");
  table.list("obstacles", obstacle_keys(), store_wall("center"), "solid boxes among the fibers")
      .otherwise("none");
  table
      .list("cones", cone_keys(), store_wall("axis"),
            "shells of finite cones, open at both ends, which fibers touch from inside and outside")
      .otherwise("none");
  table.list("meshes", mesh_wall_keys(), &store_mesh_wall, "surfaces of triangles, from files")
      .otherwise("none");
  return table;
}

}  // namespace

double largest_diameter(const PackingScene& scene) {
  double largest = 0;
  for (const PackingFiberKind& kind : scene.kinds) largest = std::max(largest, kind.fiber.diameter);
  return largest;
}

void declare_walls(KeyTable<PackingScene>& table) {
  table.mapping_into("walls", std::identity{}, wall_keys(), "walls, which may move").otherwise("none");
}

}  // namespace fiberchain::dem
