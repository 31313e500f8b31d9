#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "dem/contact/contact_law.hpp"
#include "dem/mesh/mesh_shape.hpp"
#include "dem/model/errors.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/check_packing.hpp"
#include "dem/scene/fiber_csv.hpp"
#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::size_t kLargestStarts = 256 * 1024 * 1024;
constexpr ValueRange kCounts{.low = 1, .high = 1e7};
constexpr ValueRange kIntervals{.low = 0, .high = 1e6};
constexpr ValueRange kBondAngle{.low = -std::numbers::pi, .high = std::numbers::pi};

/// An entry of list "fibers" as typed.
struct FiberKindKeys : FiberKeys {
  BondKeys bond = {};
  double rest_angle = 0;  ///< [rad]
  bool smooth = false;
  std::string name;
  std::int64_t count = 0;
  std::string starts;
};

/// Mapping "curvature" as typed.
struct CurvatureKeys {
  std::optional<double> radius;  ///< [m], or
  std::optional<double> angle;   ///< [rad]
};

KeyTable<CurvatureKeys> curvature_keys() {
  KeyTable<CurvatureKeys> table;
  table.quantity("radius", "m", &CurvatureKeys::radius, kPositive,
                 "radius of the arc through the spheres' centers, at least the length of a bond");
  table.quantity("angle", "rad", &CurvatureKeys::angle, kBondAngle, "angle between the ends of a bond");
  table.one_of({"radius", "angle"});
  return table;
}

/// Angle of a bond at rest: its chord is the bond's length, 2 r sin(angle / 2).
void store_curvature(const StrictMapping& mapping, const CurvatureKeys& keys, FiberKindKeys& kind) {
  const double chord = kind.diameter * (kind.aspect_ratio / bonds_of(kind));
  kind.rest_angle =
      keys.angle ? *keys.angle : 2 * std::asin(chord / 2 / mapping.quantity("radius", "m", {.low = chord}));
}

KeyTable<FiberKindKeys> fiber_kind_keys() {
  KeyTable<FiberKindKeys> table;
  declare_fiber(table);
  const auto store_bond = [](const StrictMapping&, const BondKeys& bond, FiberKindKeys& kind) {
    kind.bond = bond;
  };
  table.mapping("bond", bond_keys({.rolling_friction = true, .failure = true}), store_bond,
                "the bonds between the spheres");
  table.mapping("curvature", curvature_keys(), &store_curvature, "arc at rest").otherwise("straight");
  table.choice("surface", &FiberKindKeys::smooth, Words<bool>{{"spheres", false}, {"smooth", true}},
               "what touches other fibers: the spheres, or the cylinders between them with round ends");
  table
      .word("name", &FiberKindKeys::name, "text",
            "by which `contacts.pairs` and `held` call these fibers; no other fibers have it, and no wall")
      .otherwise("none");
  table.integer("count", &FiberKindKeys::count, kCounts,
                "number of fibers at random, in all batches together");
  table
      .word("starts", &FiberKindKeys::starts, "path",
            "CSV file beside the scene, a fiber a line: `x,y,z` (center of the first sphere [m]), `ux,uy,uz` "
            "(unit "
            "vector along the fiber) and, where fibers move, `vx,vy,vz` [m/s]")
      .content_counts();
  table.one_of({"count", "starts"});
  return table;
}

/// The file stands beside the scene's, unless its path is absolute.
void read_starts(const StrictMapping& mapping, const std::string& file, PackingFiberKind& kind) {
  const std::filesystem::path path = std::filesystem::path(mapping.file()).parent_path() / file;
  try {
    kind.file = read_scene_text(path, kLargestStarts);
    std::istringstream text(kind.file->text);
    kind.starts = read_fiber_starts(text, path.string());
  } catch (const SceneError& error) {
    mapping.fail("starts", error.what());
  }
}

void store_fiber_kind(const StrictMapping& mapping, const FiberKindKeys& keys, PackingScene& scene) {
  ReadFiber read = fiber_of(mapping, "", keys);
  PackingFiberKind kind{.fiber = std::move(read.fiber),
                        .count = keys.count,
                        .damping = std::move(read.damping),
                        .material_file = std::move(read.material_file),
                        .name = keys.name};
  kind.fiber.rest_angle = keys.rest_angle;
  kind.smooth = keys.smooth;
  apply(keys.bond, kind.fiber);
  try {
    chain_of(kind);
  } catch (const InvalidInput& error) {
    mapping.fail("curvature", error.what());
  }
  if (!keys.starts.empty()) read_starts(mapping, keys.starts, kind);
  for (const PackingFiberKind& other : scene.kinds) {
    if (!kind.name.empty() && other.name == kind.name)
      mapping.fail("name", fmt::format("'{}' is that of other fibers already", kind.name));
  }
  scene.kinds.push_back(std::move(kind));
}

KeyTable<PackingScene> packing_motion_keys() {
  KeyTable<PackingScene> table;
  table.quantity("step", "s", &PackingScene::step, kPositive, "time step")
      .otherwise(
          "0.9 of the largest stable step, less where the speeds there are or may come and "
          "`restitution_error` want it");
  table
      .number("restitution_error", &PackingScene::restitution_error,
              {.low = 1e-5, .high = 1, .high_open = true},
              "how far the chosen step may take the coefficient of restitution off; where nothing is lost it "
              "bounds how far the energy wanders, too: 1e-3 to 4 %")
      .only_with("a step that is chosen", [](const PackingScene& scene) { return !scene.step; });
  table.choice(
      "integrator", &PackingScene::integrator,
      words_of({Integrator::leapfrog, Integrator::leapfrog_stiff, Integrator::automatic}),
      "bonds explicit, or solved for within the step so that contacts and bending set it; `auto`: the one "
      "that costs less by its steps");
  table.choice(
      "form", &PackingScene::form, words_of({BondForm::total, BondForm::incremental}),
      "strains of the bonds from the poses of the spheres, or summed over the steps as the paper does");
  table.choice("rolling", &PackingScene::rolling, words_of({Rolling::set_valued, Rolling::explicit_sign}),
               "rolling friction of the bonds solved within the step, or by the sign of the lagged spin");
  table.flag("orientations", &PackingScene::orientations,
             "follow orientations of spheres where nothing needs them");
  table
      .flag("allow_unstable", &PackingScene::allow_unstable,
            "march even beyond the stable step of the contacts")
      .only_with("step", [](const PackingScene& scene) { return scene.step.has_value(); });
  return table;
}

KeyTable<PackingScene> output_keys() {
  KeyTable<PackingScene> table;
  table.integer(
      "samples", [](PackingScene & scene) -> auto& { return scene.output.samples; }, kIntervals,
      "intervals of NAME-log.csv; 0: no log");
  table.integer(
      "frames", [](PackingScene & scene) -> auto& { return scene.output.frames; }, kIntervals,
      "intervals of the trajectory NAME.h5; 0: no trajectory");
  table.integer(
      "checkpoints", [](PackingScene & scene) -> auto& { return scene.output.checkpoints; }, kIntervals,
      "intervals of NAME.checkpoint; 0: one only where the run is stopped");
  table.flag(
      "vtk", [](PackingScene & scene) -> auto& { return scene.output.vtk; }, "frames as VTK files too");
  table.flag(
      "contacts", [](PackingScene & scene) -> auto& { return scene.output.contacts; },
      "contacts of frames too, with their forces: in NAME.h5 and, where asked for, in VTK files");
  table.flag("energy", &PackingScene::account_energy, "sum the energy that each mechanism dissipates");
  return table;
}

KeyTable<PackingScene> packing_keys() {
  KeyTable<PackingScene> table;
  table.known("scene", "packing", "many fibers that touch each other and walls");
  declare_start_from(table);
  table.list("fibers", fiber_kind_keys(), &store_fiber_kind, "kinds of fibers").required();
  declare_domain(table);
  declare_filling(table);
  declare_held(table);
  table.mapping_into("motion", std::identity{}, packing_motion_keys(), "integration in time");
  table.quantity("duration", "s", &PackingScene::duration, kPositive, "length of the run");
  table.integer("steps", &PackingScene::steps, {.low = 1, .high = 2e9}, "the same in time steps");
  table.one_of({"duration", "steps"});
  table.mapping_into("output", std::identity{}, output_keys(), "files of the run");
  return table;
}

/// A plane on a box's own floor, a wall typed twice. Walls of the box count first, then planes and so on.
void check_walls_differ(const StrictMapping& top, const std::vector<Wall>& walls) {
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!are_same(walls[i], walls[j])) continue;
      top.fail("walls",
               fmt::format("has the same {} twice (walls {} and {}, those of the box first): spheres "
                           "would be pushed by both",
                           walls[i].shape.type().name, j + 1, i + 1));
    }
  }
}

/// A name stands for fibers or for walls.
void check_names(const StrictMapping& top, const PackingScene& scene) {
  for (const Wall& wall : scene.domain.walls) {
    if (wall.name.empty() ||
        std::ranges::find(scene.kinds, wall.name, &PackingFiberKind::name) == scene.kinds.end())
      continue;
    top.fail("walls", fmt::format("have the name '{}', which fibers have", wall.name));
  }
}

/// Plates that stand face to face for a while, nearer than a fiber is thick.
void check_plates(const StrictMapping& top, const PackingScene& scene) {
  const double diameter = largest_diameter(scene);
  const std::vector<Wall>& walls = scene.domain.walls;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto *a = walls[j].shape.get_if<Plane>(), *b = walls[i].shape.get_if<Plane>();
      if (!a || !b || dot(a->normal, b->normal) > -1 + 1e-12) continue;
      const bool together = std::max(walls[i].active_from, walls[j].active_from) <
                            std::min(walls[i].active_until, walls[j].active_until);
      if (walls[i].motion.moves() || walls[j].motion.moves()) continue;
      if (!together || dot(walls[i].velocity - walls[j].velocity, a->normal) != 0) continue;
      const double gap = dot(b->point - a->point, a->normal);
      if (gap >= diameter * (1 - 1e-9)) continue;
      top.fail("walls",
               fmt::format("leave {:g} m between walls {} and {} (those of the box first), which face each "
                           "other; allowed: at least the fibers' diameter, {:g} m",
                           gap, j + 1, i + 1, diameter));
    }
  }
}

/// Spheres that are held.
void check_held(const StrictMapping& top, const PackingScene& scene) {
  if (scene.held.empty()) return;
  if (scene.domain.fluid) top.fail("fluid", "is not built together with spheres that are held or loaded");
  for (const SceneGrip& held : scene.held) {
    if (scene.kinds[held.kind].fiber.rolling_friction > 0 && scene.rolling == Rolling::set_valued)
      top.fail(held.is_load ? "loads" : "held",
               "are built together with rolling friction of the bonds with motion.rolling: explicit_sign");
  }
  if (scene.start_from) return;  // its file has other fibers at the start
  try {
    grips_of(scene);
  } catch (const InvalidKey& error) {
    top.fail_within(error.key, error.what());
  }
}

/// What is not built with smooth fibers.
void check_smooth(const StrictMapping& top, const PackingScene& scene) {
  if (std::ranges::none_of(scene.kinds, &PackingFiberKind::smooth)) return;
  if (law_of(scene.domain.contacts).adheres)
    top.fail("contacts", "law is not built for fibers with surface: smooth; allowed: hertz_mindlin");
  for (const PackingFiberKind& kind : scene.kinds) {
    if (kind.smooth && kind.fiber.strength && kind.fiber.spacing < 1)
      top.fail("fibers",
               "with surface: smooth that break need spacing: 1 or more, or their pieces would overlap");
  }
}

/// What is not built together.
void check_together(const StrictMapping& top, const PackingScene& scene) {
  check_spacing(top, scene);
  for (const PackingFiberKind& kind : scene.kinds) {
    check_branches(top, kind.fiber);
    check_failure(top, kind.fiber);
    if (scene.domain.fluid && fails(kind.fiber) && scene.integrator != Integrator::leapfrog)
      top.fail("fluid", "is built together with bonds that break or yield for integrator: leapfrog");
    if (scene.domain.fluid && !kind.fiber.branches.empty())
      top.fail("fluid", "is not built together with material_damping");
    if (kind.fiber.rolling_friction == 0) continue;
    if (scene.form != BondForm::incremental) {
      top.fail("motion", "rolling friction of the bonds is built for form: incremental");
    }
    if (scene.domain.fluid) top.fail("fluid", "is not built together with rolling friction of the bonds");
    if (scene.integrator == Integrator::leapfrog_stiff)
      top.fail("motion", "rolling friction of the bonds is built for integrator: leapfrog");
  }
  check_smooth(top, scene);
  check_walls_differ(top, scene.domain.walls);
  check_plates(top, scene);
  check_names(top, scene);
  check_held(top, scene);
  const auto is_driven = [](const Wall& wall) { return wall.motion.drive.has_value(); };
  if (scene.batches.number > 1 && std::ranges::any_of(scene.domain.walls, is_driven))
    top.fail("filling", "in batches is not built together with walls that a force drives");
  const bool at_zero = !scene.start_from || scene.start_from->clock == StartClock::zero;
  if (at_zero && scene.duration > 0 &&
      !((scene.batches.number - 1) * scene.batches.interval < scene.duration)) {
    top.fail("duration", "ends before the last batch of fibers comes");
  }
}

}  // namespace

std::vector<KeyDeclaration> packing_declarations() { return packing_keys().declarations(); }

PackingScene read_packing(const StrictMapping& top) {
  PackingScene scene = packing_keys().read_strictly(top);
  check_number(top, scene);
  complete_scene_box(scene);
  check_together(top, scene);
  if (!scene.start_from) check_starts(top, scene);  // fibers of a file are no longer where they started
  check_plan(top, scene);
  return scene;
}

}  // namespace fiberchain::dem
