#include "dem/scene/read_common.hpp"

#include <cmath>

#include "dem/model/errors.hpp"

namespace fiberchain::dem {
std::array<double, 3> read_direction(const StrictMapping& section, const char* key, Dimension dimension) {
  auto direction = section.vector(key);
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (!(length > 0) || !std::isfinite(length)) section.fail(key, "must not be zero");
  if (dimension == Dimension::planar && direction[2] != 0) {
    section.fail(key, "must lie in the x-y plane where the scene is planar");
  }
  for (double& component : direction) component /= length;
  return direction;
}

Fiber read_fiber(const StrictMapping& top) { return read_fiber_keys(top.section("fiber", kFiberKeys)); }

Fiber read_fiber_keys(const StrictMapping& section) {
  Fiber fiber{};
  fiber.diameter = section.quantity("diameter", "m", kPositive);
  fiber.aspect_ratio = section.integer("aspect_ratio", {.low = 1, .high = 1e6});
  const double youngs_modulus = section.quantity("youngs_modulus", "Pa", kPositive);
  const double density = section.quantity("density", "kg/m^3", kPositive);
  if (section.one_of({"poisson_ratio", "shear_modulus"}) == "poisson_ratio") {
    const double poisson = section.number("poisson_ratio", {.low = -1, .high = 0.5, .low_open = true});
    fiber.material = isotropic_material(youngs_modulus, poisson, density);
  } else {
    fiber.material = {youngs_modulus, section.quantity("shear_modulus", "Pa", kPositive), density};
  }
  return fiber;
}

void check_fiber(const StrictMapping& section, const Fiber& fiber, const char* key) {
  try {
    check(fiber);
  } catch (const InvalidInput& error) {
    section.fail(key, error.what());
  }
  if (!std::isnormal(sphere_inertia(fiber)) || !std::isnormal(bending_stiffness(fiber)) ||
      !std::isnormal(load_force(fiber, 1.0))) {
    section.fail(key, "is too small or too large for the numbers of a computer");
  }
}

void read_bond(const StrictMapping& section, Fiber& fiber, BondForm& form) {
  if (section.has("model")) {
    const bool paper = section.choice("model", {"paper", "corrected"}) == 0;
    fiber.bond_model = paper ? BondModel::paper : BondModel::corrected;
  }
  if (section.has("form")) {
    const bool total = section.choice("form", {"total", "incremental"}) == 0;
    form = total ? BondForm::total : BondForm::incremental;
  }
  if (section.has("damping")) fiber.bond_damping = section.number("damping", kNonNegative);
}

EndPull read_load(const StrictMapping& top, const Fiber& fiber, Dimension dimension) {
  const StrictMapping section = top.section("load", {"reduced", "force", "direction"});
  EndPull pull{};
  if (section.one_of({"reduced", "force"}) == "reduced") {
    pull.load = section.number("reduced", kNonNegative);
  } else {
    pull.load = section.quantity("force", "N", kNonNegative) / load_force(fiber, 1.0);
    if (!std::isfinite(pull.load)) section.fail("force", "is too large for this fiber");
  }
  if (section.has("direction")) pull.direction = read_direction(section, "direction", dimension);
  return pull;
}

Dimension read_dimension(const StrictMapping& top) {
  if (!top.has("dimension")) return Dimension::planar;
  return static_cast<Dimension>(top.choice("dimension", {"planar", "spatial"}));
}

}  // namespace fiberchain::dem
