#include "dem/scene/read_common.hpp"

#include <fmt/format.h>
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

Material material_of(const FiberKeys& keys) {
  const double E = keys.youngs_modulus;
  if (!keys.shear_modulus) return isotropic_material(E, keys.poisson_ratio.value(), keys.density);
  Material material{E, *keys.shear_modulus, keys.density};
  if (keys.poisson_ratio || keys.transverse_modulus) {
    const double nu = keys.poisson_ratio.value_or(contact_elasticity(material).poisson_ratio);
    material.across = {keys.transverse_modulus.value_or(E), nu};
  }
  return material;
}

/// A pull of E A doubles the length of straight bonds: P L^2 / (E I) = 16 r_f^2.
void check_stretch(const StrictMapping& load, const LoadKeys& keys, const Fiber& fiber, double reduced) {
  const double ratio = fiber.aspect_ratio, most = 16 * ratio * ratio;
  if (reduced <= most) return;
  load.fail(
      keys.reduced ? "reduced" : "force",
      fmt::format("{:g} is not allowed: it stretches the fiber to more than twice its length; allowed: "
                  "at most {:g}",
                  keys.reduced ? *keys.reduced : *keys.force, keys.reduced ? most : load_force(fiber, most)));
}

}  // namespace

Fiber fiber_of(const StrictMapping& mapping, const std::string& key, const FiberKeys& keys) {
  Fiber fiber{};
  fiber.diameter = keys.diameter;
  fiber.aspect_ratio = keys.aspect_ratio;
  fiber.mass = keys.mass;
  fiber.material = material_of(keys);
  check_fiber(mapping, key, fiber);
  return fiber;
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
  table.number("damping", &BondKeys::damping, kCoefficient, "damping ratio ξ_b of the bonds' dashpots");
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
  return table;
}

void apply(const BondKeys& keys, Fiber& fiber) {
  fiber.bond_model = keys.model;
  fiber.bond_damping = keys.damping;
  fiber.rolling_friction = keys.rolling_friction;
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

void check_planar(const StrictMapping& mapping, const char* key, const std::array<double, 3>& direction,
                  Dimension dimension) {
  if (dimension == Dimension::planar && direction[2] != 0) {
    mapping.fail(key, "must lie in the x-y plane where the scene is planar");
  }
}

}  // namespace fiberchain::dem
