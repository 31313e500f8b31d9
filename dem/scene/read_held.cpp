#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "dem/files/nearest_word.hpp"
#include "dem/files/numbers.hpp"
#include "dem/scene/read_common.hpp"

// Spheres that a scene holds, drives or loads.
namespace fiberchain::dem {
namespace {

using Axes = std::array<bool, 3>;

/// Which spheres, as typed.
struct SelectionKeys {
  std::string fibers, spheres;
  std::optional<std::int64_t> fiber;
};

/// An entry of list "held" as typed.
struct HeldKeys : Wall, SelectionKeys {
  Axes place{true, true, true}, turn{true, true, true};
};

/// An entry of list "loads" as typed.
struct LoadedKeys : Wall, SelectionKeys {
  Vec<double, 3> force{}, moment{};
  double ramp = 0;
};

template <class T>
void declare_selection(KeyTable<T>& table) {
  table.word("name", &T::name, "text", "by which NAME-held.csv calls it").otherwise("none");
  table.word("fibers", &T::fibers, "text", "`name` of their kind").otherwise("the only kind");
  table
      .integer("fiber", &T::fiber, {.low = 0, .high = 1e7},
               "number of the fiber among those of its kind that are there at the start, from 0: as in "
               "`starts`, of `count` as they are put in")
      .otherwise("all of them");
  table
      .word("spheres", &T::spheres, "`first`, `last`, `ends`, `all`, `N` or `N..M`",
            "of each of these fibers, numbered from 0")
      .required();
}

std::size_t kind_named(const StrictMapping& mapping, const std::string& name, const PackingScene& scene) {
  if (name.empty()) {
    if (scene.kinds.size() > 1) mapping.fail_missing("fibers");
    return 0;
  }
  std::vector<std::string> known_names;
  for (std::size_t k = 0; k < scene.kinds.size(); ++k) {
    if (scene.kinds[k].name == name) return k;
    if (!scene.kinds[k].name.empty()) known_names.push_back(scene.kinds[k].name);
  }
  mapping.fail("fibers",
               fmt::format("'{}' is the name of no fibers; {}", name,
                           known_names.empty() ? "none has a `name`" : dem::suggestion(name, known_names)));
}

std::vector<int> spheres_named(const StrictMapping& mapping, const std::string& word, int bonds) {
  if (word == "first") return {0};
  if (word == "last") return {bonds};
  if (word == "ends") return {0, bonds};
  std::optional<std::int64_t> from = 0, to = bonds;
  if (word != "all") {
    const std::size_t dots = word.find("..");
    from = parse_integer(word.substr(0, dots));
    to = dots == std::string::npos ? from : parse_integer(word.substr(dots + 2));
  }
  if (!from || !to || *from < 0 || *to < *from || *to > bonds) {
    mapping.fail("spheres", fmt::format("'{}' is not allowed; allowed: first, last, ends, all, N or N..M of "
                                        "the spheres 0 to {}",
                                        word, bonds));
  }
  std::vector<int> spheres;
  for (auto i = static_cast<int>(*from); i <= static_cast<int>(*to); ++i) spheres.push_back(i);
  return spheres;
}

SceneGrip selected(const StrictMapping& mapping, const SelectionKeys& keys, const Wall& body,
                   const PackingScene& scene) {
  if (!(body.active_from < body.active_until)) mapping.fail("until", "must be later than from");
  SceneGrip grip;
  grip.kind = kind_named(mapping, keys.fibers, scene);
  grip.grip.body = body, grip.fiber = keys.fiber;
  grip.spheres = spheres_named(mapping, keys.spheres, scene.kinds[grip.kind].fiber.aspect_ratio);
  return grip;
}

KeyTable<HeldKeys> held_keys() {
  KeyTable<HeldKeys> table(HeldKeys{Wall{Plane{}}, {}});
  declare_selection(table);
  table.choice("place", &HeldKeys::place, axis_words(), "along which axes their places are held");
  table.choice("turn", &HeldKeys::turn, axis_words(), "about which axes their rotations are held");
  declare_rigid_motion(table, "constant velocity of what holds them, with all of them as one rigid body",
                       "they are held from this time on, where they are then", "and free from this time on");
  return table;
}

KeyTable<LoadedKeys> load_keys_of_spheres() {
  KeyTable<LoadedKeys> table(LoadedKeys{Wall{Plane{}}, {}});
  declare_selection(table);
  table.vector("force", "N", &LoadedKeys::force, "force on each of the spheres");
  table.vector("moment", "N m", &LoadedKeys::moment, "moment on each of them");
  table.one_or_more_of({"force", "moment"});
  table.quantity("ramp", "s", &LoadedKeys::ramp, kNonNegative, "time in which they rise smoothly from 0");
  declare_times(table, "they act from this time on", "and no longer from this time on");
  return table;
}

void store_held(const StrictMapping& mapping, const HeldKeys& keys, PackingScene& scene) {
  SceneGrip held = selected(mapping, keys, keys, scene);
  held.grip.place = keys.place, held.grip.turn = keys.turn;
  if (!held.grip.holds()) mapping.fail("place", "must not be none where turn is none");
  scene.held.push_back(std::move(held));
}

void store_load(const StrictMapping& mapping, const LoadedKeys& keys, PackingScene& scene) {
  SceneGrip load = selected(mapping, keys, keys, scene);
  load.is_load = true;
  load.grip.force = keys.force, load.grip.moment = keys.moment, load.grip.ramp = keys.ramp;
  scene.held.push_back(std::move(load));
}

}  // namespace

void declare_held(KeyTable<PackingScene>& table) {
  table
      .list("held", held_keys(), &store_held,
            "spheres that are held, clamped or driven; what that takes is in NAME-held.csv")
      .otherwise("none");
  table.list("loads", load_keys_of_spheres(), &store_load, "forces and moments on spheres").otherwise("none");
}

}  // namespace fiberchain::dem
