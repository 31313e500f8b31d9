#include <numbers>

#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

/// Sides of the region as typed [m].
using RegionKeys = std::array<std::optional<std::array<double, 2>>, 3>;

/// Mapping "filling" as typed.
struct FillingKeys {
  std::optional<RegionKeys> region;
  InsertionRules rules{};
  Batches batches{};
};

KeyTable<RegionKeys> region_keys() {
  KeyTable<RegionKeys> table;
  for (int a = 0; a < 3; ++a) {
    table
        .interval(
            kAxes[a], "m", [a](RegionKeys & sides) -> auto& { return sides[a]; },
            std::string("ends of the region along ") + kAxes[a])
        .otherwise("the side of the box or periodic cell; required without");
  }
  return table;
}

KeyTable<Batches> batch_keys() {
  KeyTable<Batches> table;
  table
      .integer("number", &Batches::number, {.low = 1, .high = 1e5},
               "number of equal parts, the first at the start")
      .required();
  table.quantity("interval", "s", &Batches::interval, kPositive, "time between two parts").required();
  table.choice(
      "no_room", &Batches::no_room,
      Words<NoRoomChoice>{
          {"end", NoRoomChoice::end}, {"wait", NoRoomChoice::wait}, {"fewer", NoRoomChoice::fewer}},
      "where a later part finds no room: end the run with its files and row, wait and try again ten times "
      "an interval, or take as many fibers as find a place");
  return table;
}

KeyTable<FillingKeys> filling_keys() {
  KeyTable<FillingKeys> table;
  const auto aligned = [](const FillingKeys& keys) {
    return keys.rules.orientation.alignment != Alignment::isotropic;
  };
  const Words<Alignment> alignments = {{"isotropic", Alignment::isotropic},
                                       {"near_axis", Alignment::near_axis},
                                       {"near_plane", Alignment::near_plane}};
  const char* any_aligned = "orientation: near_axis or near_plane";
  const auto store_region = [](const StrictMapping&, const RegionKeys& region, FillingKeys& keys) {
    keys.region = region;
  };
  table.mapping("region", region_keys(), store_region,
                "region that holds all spheres wholly, clear of walls");
  table.choice(
      "orientation", [](FillingKeys & keys) -> auto& { return keys.rules.orientation.alignment; }, alignments,
      "directions of the fibers: any, within `angle` of an axis, or within `angle` of a plane");
  table
      .direction(
          "direction", [](FillingKeys & keys) -> auto& { return keys.rules.orientation.direction; },
          "the axis, or the normal of the plane")
      .required()
      .only_with(any_aligned, aligned);
  table
      .quantity(
          "angle", "rad", [](FillingKeys & keys) -> auto& { return keys.rules.orientation.angle; },
          {.low = 0, .high = std::numbers::pi / 2}, "largest angle from the axis or plane")
      .required()
      .only_with(any_aligned, aligned);
  table.vector(
      "velocity", "m/s", [](FillingKeys & keys) -> auto& { return keys.rules.velocity; },
      "velocity of all spheres at the start");
  table.quantity(
      "gap", "m", [](FillingKeys & keys) -> auto& { return keys.rules.gap; }, kNonNegative,
      "least distance between surfaces");
  table.integer(
      "seed", [](FillingKeys & keys) -> auto& { return keys.rules.seed; }, kNonNegative,
      "seed of the random numbers; the same seed gives the same packing");
  table.integer(
      "attempts", [](FillingKeys & keys) -> auto& { return keys.rules.attempts; }, {.low = 1, .high = 1e9},
      "positions tried for a fiber before the filling is given up");
  table.mapping_into("batches", &FillingKeys::batches, batch_keys(), "insertion in several parts")
      .otherwise("all at the start");
  return table;
}

/// Sides of the region; those left out are the scene box's.
Box region_of(const StrictMapping& filling, const FillingKeys& keys, const Box& scene_box) {
  Box region = scene_box;
  for (int a = 0; a < 3; ++a) {
    const std::string axis = kAxes[a];
    if (keys.region && (*keys.region)[a]) {
      region.low[a] = (*(*keys.region)[a])[0], region.high[a] = (*(*keys.region)[a])[1];
    } else if (!(region.high[a] > region.low[a])) {
      filling.fail(keys.region ? "region" : "", "key '" + (keys.region ? axis : "region." + axis) +
                                                    "' is missing: neither box nor periodic has this side");
    }
  }
  return region;
}

/// Every batch needs a fiber at the start of the run.
void check_batches(const StrictMapping& filling, const PackingScene& scene) {
  if (!filling.has("batches")) return;
  std::int64_t most = 0, placed = 0;
  for (const PackingFiberKind& kind : scene.kinds)
    most = std::max(most, kind.count), placed += std::ssize(kind.starts);
  if (placed == 0 && scene.batches.number > most) {
    filling.mapping("batches").fail(
        "number", fmt::format("leaves no fiber for the first batch; allowed: at most {}", most));
  }
}

void store_filling(const StrictMapping& mapping, const FillingKeys& keys, PackingScene& scene) {
  scene.filling = keys.rules;
  scene.filling.region = region_of(mapping, keys, scene.scene_box);
  scene.batches = keys.batches;
  check_batches(mapping, scene);
}

bool has_random_fibers(const PackingScene& scene) {
  return std::ranges::any_of(scene.kinds, [](const PackingFiberKind& kind) { return kind.count > 0; });
}

}  // namespace

void declare_filling(KeyTable<PackingScene>& table) {
  table.mapping("filling", filling_keys(), &store_filling, "random insertion of the fibers")
      .required()
      .only_with("fibers that have a count", &has_random_fibers);
}

}  // namespace fiberchain::dem
