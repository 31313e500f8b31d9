#include "dem/scene/read_common.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
namespace {

void check_fiber(const StrictMapping& mapping, const std::string& key, const Fiber& fiber) {
  try {
    check(fiber);
  } catch (const InvalidInput& error) {
    mapping.fail(key, error.what());
  }
  if (!std::isnormal(sphere_inertia(fiber)) || !std::isnormal(bending_stiffness(fiber)) ||
      !std::isnormal(load_force(fiber, 1.0))) {
    mapping.fail(key, "is too small or too large for the numbers of a computer");
  }
}

/// The keys with what they leave to the material.
FiberKeys completed(FiberKeys keys, const std::optional<MaterialData>& material) {
  if (!material) return keys;
  const auto take = [](std::optional<double>& key, const std::optional<MaterialValue>& known) {
    if (!key && known) key = known->value;
  };
  take(keys.youngs_modulus, material->youngs_modulus);
  take(keys.density, material->density);
  if (!keys.poisson_ratio && !keys.shear_modulus) {
    take(keys.poisson_ratio, material->poisson_ratio);
    take(keys.shear_modulus, material->shear_modulus);
  }
  if (keys.shear_modulus) take(keys.transverse_modulus, material->transverse_modulus);
  return keys;
}

void check_complete(const StrictMapping& mapping, const FiberKeys& keys) {
  const std::string not_there =
      keys.material.empty() ? "" : fmt::format(": material '{}' has none", keys.material);
  const auto require = [&](const char* key, const std::optional<double>& value) {
    if (!value) mapping.fail("", fmt::format("key '{}' is missing{}", key, not_there));
  };
  require("youngs_modulus", keys.youngs_modulus);
  if (!keys.poisson_ratio && !keys.shear_modulus)
    mapping.fail("", "needs poisson_ratio or shear_modulus" + not_there);
  if (keys.transverse_modulus && !keys.shear_modulus)
    mapping.fail("transverse_modulus", "is of use only with shear_modulus");
  require("density", keys.density);
}

/// The material named, found beside the scene.
std::optional<MaterialData> material_named(const StrictMapping& mapping, const FiberKeys& keys) {
  if (keys.material.empty()) return std::nullopt;
  try {
    return find_material(keys.material, mapping.file(), mapping.units());
  } catch (const SceneError& error) {
    mapping.fail("material", error.what());
  }
}

DampedFiber with_material_damping(const StrictMapping& mapping, const FiberKeys& keys, const Fiber& fiber,
                                  const std::optional<MaterialData>& material) {
  if (!keys.material_damping) return {fiber, {}};
  const MaterialDamping damping = damping_of(mapping, *keys.material_damping, material);
  try {
    return with_damping(fiber, damping);
  } catch (const InvalidInput& error) {
    mapping.fail("material_damping", error.what());
  }
}

Material material_of(const FiberKeys& keys) {
  const double E = keys.youngs_modulus.value(), density = keys.density.value();
  if (!keys.shear_modulus) return isotropic_material(E, keys.poisson_ratio.value(), density);
  Material material{E, *keys.shear_modulus, density};
  if (keys.poisson_ratio || keys.transverse_modulus) {
    const double nu = keys.poisson_ratio.value_or(contact_elasticity(material).poisson_ratio);
    material.across = {keys.transverse_modulus.value_or(E), nu};
  }
  return material;
}

/// The number of bonds, and their length such that they make up the fiber's to the bit.
void set_bonds(const StrictMapping& mapping, const FiberKeys& keys, Fiber& fiber) {
  constexpr double off = 1e-5,
                   most = 1e6;  // six digits of a spacing are enough; bonds as aspect_ratio allows
  const double bonds = bonds_of(keys), asked = keys.aspect_ratio / keys.spacing;
  if (std::abs(asked - bonds) > off * bonds || bonds > most) {
    const double fewer = std::clamp(std::floor(asked), 1.0, most), more = std::min(fewer + 1, most);
    mapping.fail("spacing",
                 fmt::format("{:g} is not allowed: {} diameters are {:.6g} bonds of that length, which "
                             "must be a whole number, at most {:g}; next to it: {:.7g} ({:.0f} bonds), "
                             "{:.7g} ({:.0f})",
                             keys.spacing, keys.aspect_ratio, asked, most, keys.aspect_ratio / fewer, fewer,
                             keys.aspect_ratio / more, more));
  }
  fiber.aspect_ratio = static_cast<int>(bonds);
  fiber.spacing = keys.aspect_ratio / bonds;
}

/// A pull of E A doubles the length of straight bonds: P L^2 / (E I) = 16 r_f^2.
void check_stretch(const StrictMapping& load, const LoadKeys& keys, const Fiber& fiber, double reduced) {
  const double ratio = slenderness(fiber), most = 16 * ratio * ratio;
  if (reduced <= most) return;
  load.fail(
      keys.reduced ? "reduced" : "force",
      fmt::format("{:g} is not allowed: it stretches the fiber to more than twice its length; allowed: "
                  "at most {:g}",
                  keys.reduced ? *keys.reduced : *keys.force, keys.reduced ? most : load_force(fiber, most)));
}

}  // namespace

const Words<std::array<bool, 3>>& axis_words() {
  static const Words<std::array<bool, 3>> words{{"xyz", {true, true, true}}, {"xy", {true, true, false}},
                                                {"xz", {true, false, true}}, {"yz", {false, true, true}},
                                                {"x", {true, false, false}}, {"y", {false, true, false}},
                                                {"z", {false, false, true}}, {"none", {false, false, false}}};
  return words;
}

double bonds_of(const FiberKeys& keys) { return std::max(std::round(keys.aspect_ratio / keys.spacing), 1.0); }

ReadFiber fiber_of(const StrictMapping& mapping, const std::string& key, const FiberKeys& keys) {
  Fiber fiber{};
  fiber.diameter = keys.diameter;
  set_bonds(mapping, keys, fiber);
  fiber.mass = keys.mass;
  const std::optional<MaterialData> material = material_named(mapping, keys);
  const FiberKeys all = completed(keys, material);
  check_complete(mapping, all);
  fiber.material = material_of(all);
  check_fiber(mapping, key, fiber);
  DampedFiber damped = with_material_damping(mapping, keys, fiber, material);
  return {std::move(damped.fiber), std::move(damped.summary),
          material ? std::optional(material->file) : std::nullopt};
}

KeyTable<BondKeys> bond_keys(const BondParts& parts) {
  BondKeys defaults{.model = Fiber{}.bond_model,
                    .damping = Fiber{}.bond_damping,
                    .rolling_friction = Fiber{}.rolling_friction};
  if (parts.form) defaults.form = *parts.form;
  KeyTable<BondKeys> table(defaults);
  table.choice("model", &BondKeys::model, words_of({BondModel::paper, BondModel::corrected}),
               "stiffnesses as in Nan, Wang & Tang (2015), or of the beam's shear and the chord of its arc");
  if (parts.form) {
    table.choice("form", &BondKeys::form, words_of({BondForm::total, BondForm::incremental}),
                 "strains from the poses of the spheres, or summed over the steps as the paper does");
  }
  table.number("damping", &BondKeys::damping, kCoefficient,
               "damping ratio ξ_b of the bonds' dashpots, which add to `material_damping`");
  if (parts.rolling_friction) {
    table.number("rolling_friction", &BondKeys::rolling_friction, kCoefficient,
                 "coefficient ξ_r of rolling friction between bonded spheres (Eq 21)");
  }
  if (parts.rolling) {
    table
        .choice(
            "rolling", &BondKeys::rolling, words_of({Rolling::set_valued, Rolling::explicit_sign}),
            "rolling friction solved within the step, or by the sign of the lagged spin as the paper does")
        .only_with("rolling_friction above 0",
                   [](const BondKeys& keys) { return keys.rolling_friction > 0; });
  }
  if (parts.failure) declare_failure(table);
  return table;
}

void apply(const BondKeys& keys, Fiber& fiber) {
  fiber.bond_model = keys.model;
  if (keys.model == BondModel::corrected) fiber.branches.shear = fiber.branches.bend;  // maxwell_branches()
  fiber.bond_damping = keys.damping;
  fiber.rolling_friction = keys.rolling_friction;
  apply_failure(keys, fiber);
}

KeyTable<LoadKeys> load_keys() {
  KeyTable<LoadKeys> table;
  table.number("reduced", &LoadKeys::reduced, kNonNegative, "reduced load P L² / (E I)");
  table.quantity("force", "N", &LoadKeys::force, kNonNegative, "load P");
  table.direction("direction", &LoadKeys::direction, "direction of the load; the fiber lies along x");
  table.one_of({"reduced", "force"});
  return table;
}

EndPull pull_of(const StrictMapping& load, const LoadKeys& keys, const Fiber& fiber, Dimension dimension) {
  EndPull pull{};
  pull.load = keys.reduced ? *keys.reduced : keys.force.value() / load_force(fiber, 1.0);
  check_stretch(load, keys, fiber, pull.load);
  check_planar(load, "direction", keys.direction, dimension);
  pull.direction = keys.direction;
  return pull;
}

void check_branches(const StrictMapping& top, const Fiber& fiber) {
  if (!fiber.branches.empty() && fiber.rolling_friction > 0)
    top.fail_within("rolling_friction", "is not built together with material_damping");
}

void check_planar(const StrictMapping& mapping, const char* key, const std::array<double, 3>& direction,
                  Dimension dimension) {
  if (dimension == Dimension::planar && direction[2] != 0) {
    mapping.fail(key, "must lie in the x-y plane where the scene is planar");
  }
}

}  // namespace fiberchain::dem
