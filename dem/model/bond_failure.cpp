#include "dem/model/bond_failure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dem/model/errors.hpp"
#include "dem/model/fiber.hpp"

namespace fiberchain::dem {
namespace {

void check_positive(double value, std::string_view what) {
  if (!(value > 0) || !std::isfinite(value))
    throw InvalidInput(fmt::format("{} = {} is not allowed: it must be finite and above 0", what, value));
}

void check(const BondStrength& strength) {
  if (strength.tension) check_positive(*strength.tension, "strength in tension");
  if (strength.compression) check_positive(*strength.compression, "strength in compression");
  if (strength.shear) check_positive(*strength.shear, "strength in shear");
  if (strength.torsion) check_positive(*strength.torsion, "strength in torsion");
  if (!strength.weibull) return;
  check_positive(strength.weibull->modulus, "Weibull modulus");
  check_positive(strength.weibull->reference_length, "reference length of the strength");
}

}  // namespace

std::string_view name(BreakCause cause) {
  switch (cause) {
    case BreakCause::tension:
      return "tension";
    case BreakCause::compression:
      return "compression";
    case BreakCause::shear:
      return "shear";
    case BreakCause::torsion:
      return "torsion";
    case BreakCause::by_hand:
      return "by_hand";
    default:
      return "none";
  }
}

bool fails(const Fiber& fiber) { return (fiber.strength && fiber.strength->any()) || fiber.yield; }

void check_failure(const Fiber& fiber) {
  if (fiber.strength) check(*fiber.strength);
  if (fiber.yield) {
    check_positive(fiber.yield->moment, "yield moment");
    if (!(fiber.yield->hardening >= 0 && fiber.yield->hardening < 1)) {
      throw InvalidInput(
          fmt::format("hardening = {} is not allowed: it must be from 0 to below 1", fiber.yield->hardening));
    }
  }
  if (!fails(fiber)) return;
  if (!fiber.branches.empty())
    throw InvalidInput("Maxwell branches are not built together with bonds that break or yield");
  if (fiber.rolling_friction > 0)
    throw InvalidInput("rolling friction of the bonds is not built together with bonds that break or yield");
}

void refuse_failure(const Fiber& fiber, std::string_view what) {
  if (fails(fiber))
    throw InvalidInput(fmt::format("bonds that break or yield are not allowed: not built for {}", what));
}

double weibull_factor(const WeibullSpread& spread, double bond_length, double u) {
  return std::pow(-std::log(u) * spread.reference_length / bond_length, 1 / spread.modulus);
}

double plastic_moment(double yield_stress, double radius) {
  return 4.0 / 3.0 * yield_stress * radius * radius * radius;
}

}  // namespace fiberchain::dem
