#include <cmath>
#include <numbers>
#include <sstream>

#include "dem/model/errors.hpp"
#include "dem/scene/fiber_csv.hpp"
#include "dem/scene/build_packing.hpp"
#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

constexpr std::size_t kLargestStarts = 256 * 1024 * 1024;
constexpr ValueRange kCounts{.low = 1, .high = 1e7};
constexpr ValueRange kIntervals{.low = 1, .high = 1e6};

/// Angle of a bond at rest, given as such or by the radius of the arc through the spheres' centers.
double read_bend(const StrictMapping& kind, const Fiber& fiber) {
  const StrictMapping curvature = kind.section("curvature", {"radius", "angle"});
  if (curvature.one_of({"radius", "angle"}) == "angle") {
    return curvature.quantity("angle", "rad", {.low = -std::numbers::pi, .high = std::numbers::pi});
  }
  const double chord = bond_length(fiber);
  return 2 * std::asin(chord / 2 / curvature.quantity("radius", "m", {.low = chord}));
}

/// The file stands beside the scene's, unless its path is absolute.
void read_starts(const StrictMapping& section, FiberKind& kind) {
  const std::filesystem::path path =
      std::filesystem::path(section.file()).parent_path() / section.word("starts");
  try {
    kind.file = read_scene_text(path, kLargestStarts);
    std::istringstream text(kind.file->text);
    kind.starts = read_fiber_starts(text, path.string());
  } catch (const SceneError& error) {
    section.fail("starts", error.what());
  }
}

FiberKind read_kind(const StrictMapping& section) {
  FiberKind kind{.fiber = read_fiber_keys(section)};
  BondForm form{};
  if (section.has("bond")) {
    const StrictMapping bond = section.section("bond", {"model", "damping", "rolling_friction"});
    read_bond(bond, kind.fiber, form);
    if (bond.has("rolling_friction"))
      kind.fiber.rolling_friction = bond.number("rolling_friction", kNonNegative);
  }
  check_fiber(section, kind.fiber, "");
  if (section.has("curvature")) kind.bend = read_bend(section, kind.fiber);
  try {
    chain_of(kind);
  } catch (const InvalidInput& error) {
    section.fail("curvature", error.what());
  }
  if (section.one_of({"count", "starts"}) == "count") {
    kind.count = section.integer("count", kCounts);
  } else {
    read_starts(section, kind);
  }
  return kind;
}

std::vector<FiberKind> read_kinds(const StrictMapping& top) {
  std::vector<std::string> keys = kFiberKeys;
  keys.insert(keys.end(), {"bond", "curvature", "count", "starts"});
  std::vector<FiberKind> kinds;
  for (const StrictMapping& section : top.sections("fibers", keys)) kinds.push_back(read_kind(section));
  return kinds;
}

InsertionOrientation read_orientation(const StrictMapping& filling) {
  InsertionOrientation orientation;
  if (filling.has("orientation")) {
    orientation.alignment =
        static_cast<Alignment>(filling.choice("orientation", {"isotropic", "near_axis", "near_plane"}));
  }
  const bool isotropic = orientation.alignment == Alignment::isotropic;
  for (const char* key : {"direction", "angle"}) {
    if (isotropic && filling.has(key))
      filling.fail(key, "is of use only with orientation: near_axis or near_plane");
  }
  if (isotropic) return orientation;
  const auto direction = read_direction(filling, "direction", Dimension::spatial);
  orientation.direction = {direction[0], direction[1], direction[2]};
  orientation.angle = filling.quantity("angle", "rad", {.low = 0, .high = std::numbers::pi / 2});
  return orientation;
}

/// Sides of the region; those left out are the room's.
void read_region(const StrictMapping& filling, PackingScene& scene) {
  Box& region = scene.filling.region = scene.room;
  const std::vector<std::string> axes = {"x", "y", "z"};
  const bool given = filling.has("region");
  for (int a = 0; a < 3; ++a) {
    const std::string& axis = axes[static_cast<std::size_t>(a)];
    if (given && filling.section("region", axes).has(axis)) {
      const auto ends = filling.section("region", axes).quantities(axis, "m", 2);
      if (!(ends[0] < ends[1])) filling.section("region", axes).fail(axis, "must rise: [low, high]");
      region.low[a] = ends[0], region.high[a] = ends[1];
    } else if (!(region.high[a] > region.low[a])) {
      filling.fail(given ? "region" : "", "key '" + (given ? axis : "region." + axis) +
                                              "' is missing: neither box nor periodic has this side");
    }
  }
}

void read_batches(const StrictMapping& filling, PackingScene& scene) {
  const StrictMapping batches = filling.section("batches", {"number", "interval"});
  scene.batches.number = batches.integer("number", {.low = 1, .high = 1e5});
  scene.batches.interval = batches.quantity("interval", "s", kPositive);
  std::int64_t most = 0, placed = 0;
  for (const FiberKind& kind : scene.kinds) most = std::max(most, kind.count), placed += std::ssize(kind.starts);
  if (placed == 0 && scene.batches.number > most) {
    batches.fail("number", fmt::format("leaves no fiber for the first batch; allowed: at most {}", most));
  }
}

void read_filling(const StrictMapping& top, PackingScene& scene) {
  std::int64_t counted = 0;
  for (const FiberKind& kind : scene.kinds) counted += kind.count;
  if (counted == 0) {
    if (top.has("filling")) top.fail("filling", "is of use only with fibers that have a count");
    return;
  }
  if (!top.has("filling")) top.fail("", "key 'filling' is missing: fibers that have a count need it");
  const StrictMapping filling = top.section("filling", {"region", "orientation", "direction", "angle", "velocity",
                                                  "gap", "seed", "attempts", "batches"});
  InsertionRules& rules = scene.filling;
  read_region(filling, scene);
  rules.orientation = read_orientation(filling);
  if (filling.has("velocity")) {
    const auto v = filling.quantities("velocity", "m/s", 3);
    rules.velocity = {v[0], v[1], v[2]};
  }
  if (filling.has("gap")) rules.gap = filling.quantity("gap", "m", kNonNegative);
  if (filling.has("seed")) rules.seed = static_cast<std::uint64_t>(filling.integer("seed", kNonNegative));
  if (filling.has("attempts")) rules.attempts = filling.integer("attempts", {.low = 1, .high = 1e9});
  if (filling.has("batches")) read_batches(filling, scene);
}

void read_motion(const StrictMapping& top, PackingScene& scene) {
  const StrictMapping motion = top.section("motion", {"step", "form", "rolling", "orientations"});
  if (motion.has("step")) scene.step = motion.quantity("step", "s", kPositive);
  if (motion.has("form")) {
    scene.form =
        motion.choice("form", {"total", "incremental"}) == 0 ? BondForm::total : BondForm::incremental;
  }
  if (motion.has("rolling")) {
    const bool solved = motion.choice("rolling", {"set_valued", "explicit_sign"}) == 0;
    scene.rolling = solved ? Rolling::set_valued : Rolling::explicit_sign;
  }
  if (motion.has("orientations")) scene.orientations = motion.flag("orientations");
}

void read_output(const StrictMapping& top, PackingScene& scene) {
  const StrictMapping output = top.section("output", {"samples", "frames", "checkpoints", "vtk", "energy"});
  if (output.has("samples")) scene.output.samples = output.integer("samples", kIntervals);
  if (output.has("frames")) scene.output.frames = output.integer("frames", kIntervals);
  if (output.has("checkpoints")) scene.output.checkpoints = output.integer("checkpoints", kIntervals);
  if (output.has("vtk")) scene.output.vtk = output.flag("vtk");
  if (output.has("energy")) scene.account_energy = output.flag("energy");
}

/// What the engine asked for cannot do.
void check_together(const StrictMapping& top, const PackingScene& scene) {
  for (const FiberKind& kind : scene.kinds) {
    if (kind.fiber.rolling_friction == 0) continue;
    if (scene.form != BondForm::incremental) {
      top.fail("motion", "rolling friction of the bonds is built for form: incremental");
    }
    if (scene.domain.fluid)
      top.fail("fluid", "is not built together with rolling friction of the bonds");
  }
  if (scene.duration > 0 && !((scene.batches.number - 1) * scene.batches.interval < scene.duration)) {
    top.fail("duration", "ends before the last batch of fibers comes");
  }
}

}  // namespace

PackingScene read_packing(const StrictMapping& top) {
  top.allow({"scene", "fibers", "filling", "walls", "periodic", "gravity", "fluid", "contacts", "motion",
             "duration", "steps", "output"});
  PackingScene scene{};
  scene.kinds = read_kinds(top);
  read_domain(top, scene);
  read_filling(top, scene);
  complete_domain(scene);
  if (top.has("motion")) read_motion(top, scene);
  if (top.one_of({"duration", "steps"}) == "duration") {
    scene.duration = top.quantity("duration", "s", kPositive);
  } else {
    scene.steps = top.integer("steps", {.low = 1, .high = 2e9});
  }
  if (top.has("output")) read_output(top, scene);
  check_together(top, scene);
  return scene;
}

}  // namespace fiberchain::dem
