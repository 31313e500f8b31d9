#include "dem/scene/read_common.hpp"

// Keys of bonds that break or yield.
namespace fiberchain::dem {
namespace {

KeyTable<WeibullKeys> weibull_keys() {
  KeyTable<WeibullKeys> table;
  table
      .number("modulus", &WeibullKeys::modulus, {.low = 0.1, .high = 1e4},
              "Weibull modulus m: of bonds of length l the part exp(-(l/l_0) (σ/S)^m) bears the stress σ")
      .required();
  table
      .quantity("reference_length", "m", &WeibullKeys::reference_length, kPositive,
                "length l_0, of which the part 1/e bears the strengths S")
      .otherwise("the fiber's length");
  table.integer("seed", &WeibullKeys::seed, {.low = 0, .high = 2147483647},
                "of the random strengths: the same wherever a fiber is");
  return table;
}

KeyTable<StrengthKeys> strength_keys() {
  KeyTable<StrengthKeys> table;
  const auto declare = [&](const char* key, std::optional<double> StrengthKeys::*member,
                           const char* meaning) {
    table.quantity(key, "Pa", member, kPositive, meaning).otherwise("none");
  };
  declare("tension", &StrengthKeys::tension,
          "of N/A + M R/I, N positive in tension, M the size of the bending moment");
  declare("compression", &StrengthKeys::compression, "of -N/A + M R/I");
  declare("shear", &StrengthKeys::shear, "of the shear force over the section, Q/A");
  declare("torsion", &StrengthKeys::torsion, "of the shear stress at the surface by the torque, T R/(2 I)");
  table.one_or_more_of({"tension", "compression", "shear", "torsion"});
  const auto store = [](const StrictMapping&, const WeibullKeys& keys, StrengthKeys& strength) {
    strength.weibull = keys;
  };
  table
      .mapping("weibull", weibull_keys(), store,
               "strengths that differ from bond to bond, all of a bond by the same factor; longer bonds are "
               "weaker, fibers are not")
      .otherwise("all bonds alike");
  return table;
}

KeyTable<YieldKeys> yield_keys() {
  KeyTable<YieldKeys> table;
  table.quantity("moment", "N m", &YieldKeys::moment, kPositive, "bending moment at which a bond yields");
  table.quantity("stress", "Pa", &YieldKeys::stress, kPositive,
                 "yield stress: the moment is that of the round section which yields all over, 4/3 σ R³");
  table.one_of({"moment", "stress"});
  table.number("hardening", &YieldKeys::hardening, {.low = 0, .high = 1, .high_open = true},
               "bending stiffness of a bond that yields over its elastic one; 0: ideally plastic");
  return table;
}

BondStrength strength_of(const StrengthKeys& keys, const Fiber& fiber) {
  BondStrength strength{.tension = keys.tension,
                        .compression = keys.compression,
                        .shear = keys.shear,
                        .torsion = keys.torsion,
                        .weibull = {}};
  if (keys.weibull) {
    strength.weibull = {.modulus = keys.weibull->modulus,
                        .reference_length = keys.weibull->reference_length.value_or(fiber_length(fiber)),
                        .seed = keys.weibull->seed};
  }
  return strength;
}

}  // namespace

void declare_failure(KeyTable<BondKeys>& table) {
  const auto store_strength = [](const StrictMapping&, const StrengthKeys& keys, BondKeys& bond) {
    bond.strength = keys;
  };
  table
      .mapping("strength", strength_keys(), store_strength,
               "stresses of the springs at a bond's middle, beyond which it breaks for good")
      .otherwise("none");
  const auto store_yield = [](const StrictMapping&, const YieldKeys& keys, BondKeys& bond) {
    bond.yield = keys;
  };
  table.mapping("yield", yield_keys(), store_yield, "bonds bend plastically beyond a moment")
      .otherwise("never");
}

void apply_failure(const BondKeys& keys, Fiber& fiber) {
  if (keys.strength) fiber.strength = strength_of(*keys.strength, fiber);
  if (!keys.yield) return;
  const YieldKeys& yield = *keys.yield;
  fiber.yield = BondYield{
      .moment = yield.moment ? *yield.moment : plastic_moment(yield.stress.value(), sphere_radius(fiber)),
      .hardening = yield.hardening};
}

void check_failure(const StrictMapping& top, const Fiber& fiber) {
  if (!fails(fiber)) return;
  const char* key = fiber.strength ? "strength" : "yield";
  if (!fiber.branches.empty()) top.fail_within(key, "is not built together with material_damping");
  if (fiber.rolling_friction > 0)
    top.fail_within(key, "is not built together with rolling friction of the bonds");
}

}  // namespace fiberchain::dem
