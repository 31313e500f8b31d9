#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "dem/contact/contact_law.hpp"
#include "dem/files/nearest_word.hpp"
#include "dem/scene/read_common.hpp"

// Contacts of a packing: of all, and of those that have a name.
namespace fiberchain::dem {
namespace {

constexpr ValueRange kRestitution{.low = 1e-4, .high = 1};
constexpr const char *kRestitutionMeaning = "normal coefficient of restitution e",
                     *kFrictionMeaning = "Coulomb's coefficient µ",
                     *kRollingMeaning = "coefficient µ_r of a moment of at most µ_r R* F_n against rolling";

/// An entry of list "pairs" as typed.
struct PairKeys : ContactChoices {
  std::array<std::string, 2> between;
};

template <class T>
void declare_choices(KeyTable<T>& table, bool of_fibers) {
  table.number("restitution", &T::restitution, kRestitution, kRestitutionMeaning).otherwise("that of all");
  table.number("friction", &T::friction, kCoefficient, kFrictionMeaning).otherwise("that of all");
  table.number("rolling_friction", &T::rolling_friction, kCoefficient, kRollingMeaning)
      .otherwise("that of all");
  if (!of_fibers) return;
  table
      .quantity("youngs_modulus", "Pa", &T::youngs_modulus, kPositive,
                "Young's modulus of the fibers' surface where these touch")
      .otherwise("that of all");
  table.number("poisson_ratio", &T::poisson_ratio, kPoissonRatio, "Poisson's ratio of that surface")
      .otherwise("that of all");
}

KeyTable<PairKeys> pair_keys() {
  KeyTable<PairKeys> table;
  table
      .two_words("between", &PairKeys::between, "two names, or one twice",
                 "names of fibers and walls: `[cotton, cotton]`, `[cotton, floor]`")
      .required();
  declare_choices(table, true);
  return table;
}

std::vector<std::string> names_in(const PackingScene& scene) {
  std::vector<std::string> known_names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && std::ranges::find(known_names, name) == known_names.end())
      known_names.push_back(name);
  };
  for (const PackingFiberKind& kind : scene.kinds) add(kind.name);
  for (const Wall& wall : scene.domain.walls) add(wall.name);
  return known_names;
}

/// What a name stands for; a number for it in Domain::pairs.
struct Named {
  int surface = 0;
  bool fibers = false;
};

/// All that has this name gets one number, if it has none yet.
Named named(const StrictMapping& mapping, const std::string& name, PackingScene& scene) {
  int next = 1;
  std::vector<int*> surfaces;
  bool fibers = false;
  const auto look_at = [&](auto& one, bool is_fiber) {
    next = std::max(next, one.surface + 1);
    if (one.name != name) return;
    surfaces.push_back(&one.surface);
    fibers = fibers || is_fiber;
  };
  for (PackingFiberKind& kind : scene.kinds) look_at(kind, true);
  for (Wall& wall : scene.domain.walls) look_at(wall, false);
  if (surfaces.empty()) {
    const std::vector<std::string> known_names = names_in(scene);
    mapping.fail("between",
                 fmt::format("'{}' is the name of no fibers and of no wall; {}", name,
                             known_names.empty() ? "none has a `name`" : dem::suggestion(name, known_names)));
  }
  const int number = *surfaces.front() > 0 ? *surfaces.front() : next;
  for (int* surface : surfaces) *surface = number;
  return {number, fibers};
}

void store_pair(const StrictMapping& mapping, const PairKeys& keys, PackingScene& scene) {
  const Named first = named(mapping, keys.between[0], scene), second = named(mapping, keys.between[1], scene);
  if (!first.fibers && !second.fibers)
    mapping.fail("between", fmt::format("'{}' and '{}' are both walls, which do not touch", keys.between[0],
                                        keys.between[1]));
  const ContactChoices& choices = keys;
  if (choices == ContactChoices{})
    mapping.fail("", "needs restitution, friction, rolling_friction, youngs_modulus or poisson_ratio");
  for (const SurfacePair& pair : scene.domain.pairs) {
    if (std::minmax(pair.first, pair.second) == std::minmax(first.surface, second.surface))
      mapping.fail("between", fmt::format("[{}, {}] is given twice", keys.between[0], keys.between[1]));
  }
  scene.domain.pairs.push_back({first.surface, second.surface, choices});
}

KeyTable<PackingScene> contact_keys() {
  KeyTable<PackingScene> table;
  const auto of = [](auto member) {
    return [member](PackingScene & scene) -> auto& { return scene.domain.contacts.*member; };
  };
  table
      .choice("law", of(&ContactProperties::law), contact_law_words(),
              "contact law: Hertz-Mindlin; with adhesion Johnson-Kendall-Roberts (soft) or "
              "Derjaguin-Muller-Toporov (stiff)")
      .otherwise("hertz_mindlin");
  table
      .quantity(
          "work_of_adhesion", "J/m^2", of(&ContactProperties::work_of_adhesion), kPositive,
          "w, of jkr and dmt: energy that parts a unit area; spheres come off at 3/2 π w R* and 2 π w R*")
      .otherwise("no adhesion");
  table.number("restitution", of(&ContactProperties::restitution), kRestitution, kRestitutionMeaning);
  table.number("friction", of(&ContactProperties::friction), kCoefficient, kFrictionMeaning);
  table.number("rolling_friction", of(&ContactProperties::rolling_friction), kCoefficient, kRollingMeaning);
  table
      .quantity("youngs_modulus", "Pa", of(&ContactProperties::youngs_modulus), kPositive,
                "Young's modulus of the fibers' surface where it touches; walls have their own")
      .otherwise("the fiber's");
  table
      .number("poisson_ratio", of(&ContactProperties::poisson_ratio), kPoissonRatio,
              "Poisson's ratio of that surface")
      .otherwise("the fiber's");
  table
      .list("pairs", pair_keys(), &store_pair,
            "what two things that have a `name` have of their own; it comes before what walls have")
      .otherwise("none");
  return table;
}

}  // namespace

KeyTable<ContactChoices> contact_choice_keys(bool of_fibers) {
  KeyTable<ContactChoices> table;
  declare_choices(table, of_fibers);
  return table;
}

void declare_contacts(KeyTable<PackingScene>& table) {
  table.mapping_into("contacts", std::identity{}, contact_keys(), "contacts of spheres and walls");
}

}  // namespace fiberchain::dem
