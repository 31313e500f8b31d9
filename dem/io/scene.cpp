#include "dem/io/scene.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "dem/errors.hpp"
#include "dem/io/section.hpp"

namespace fiberchain::dem::io {
namespace {

Fiber read_fiber(const Section& top) {
  const Section section = top.section(
      "fiber", {"diameter", "aspect_ratio", "youngs_modulus", "poisson_ratio", "shear_modulus", "density"});
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

void check_fiber(const Section& top, const Fiber& fiber) {
  try {
    check(fiber);
  } catch (const InvalidInput& error) {
    top.fail("fiber", error.what());
  }
  if (!std::isnormal(sphere_inertia(fiber)) || !std::isnormal(bending_stiffness(fiber)) ||
      !std::isnormal(load_force(fiber, 1.0))) {
    top.fail("fiber", "is too small or too large for the numbers of a computer");
  }
}

void read_bond(const Section& top, CantileverScene& scene) {
  if (!top.has("bond")) return;
  const Section section = top.section("bond", {"model", "form", "damping"});
  if (section.has("model")) {
    const bool paper = section.choice("model", {"paper", "corrected"}) == 0;
    scene.fiber.bond_model = paper ? BondModel::paper : BondModel::corrected;
  }
  if (section.has("form")) {
    const bool total = section.choice("form", {"total", "incremental"}) == 0;
    scene.march.form = total ? BondForm::total : BondForm::incremental;
  }
  if (section.has("damping")) scene.fiber.bond_damping = section.number("damping", kNonNegative);
}

std::array<double, 3> read_direction(const Section& load, Dimension dimension) {
  auto direction = load.vector("direction");
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (!(length > 0) || !std::isfinite(length)) load.fail("direction", "must not be zero");
  if (dimension == Dimension::planar && direction[2] != 0) {
    load.fail("direction", "must lie in the x-y plane where the scene is planar");
  }
  for (double& component : direction) component /= length;
  return direction;
}

void read_load(const Section& top, CantileverScene& scene) {
  const Section section = top.section("load", {"reduced", "force", "direction"});
  if (section.one_of({"reduced", "force"}) == "reduced") {
    scene.load = section.number("reduced", kNonNegative);
  } else {
    scene.load = section.quantity("force", "N", kNonNegative) / load_force(scene.fiber, 1.0);
    if (!std::isfinite(scene.load)) section.fail("force", "is too large for this fiber");
  }
  if (section.has("direction")) scene.direction = read_direction(section, scene.dimension);
}

void read_march(const Section& top, MarchOptions& march) {
  constexpr Interval kFraction{.low = 0, .high = 1, .low_open = true, .high_open = true};
  const Section section =
      top.section("march", {"bond_damping", "drag", "step_ratio", "ramp_periods", "residual", "max_periods"});
  const auto read = [&](const char* key, double& value, const Interval& allowed) {
    if (section.has(key)) value = section.number(key, allowed);
  };
  read("bond_damping", march.bond_damping, kNonNegative);
  read("drag", march.drag, kNonNegative);
  if (section.has("step_ratio")) march.step_ratio = section.number("step_ratio", kPositive);
  read("ramp_periods", march.ramp_periods, kNonNegative);
  read("residual", march.residual, kFraction);
  read("max_periods", march.max_periods, kPositive);
  if (march.bond_damping == 0 && march.drag == 0)
    top.fail("march", "needs bond_damping or drag above 0 to come to rest");
}

void read_method(const Section& top, CantileverScene& scene) {
  if (top.has("method")) scene.method = static_cast<Method>(top.choice("method", {"solve", "march"}));
  if (scene.method == Method::march) {
    if (top.has("march")) read_march(top, scene.march);
    return;
  }
  if (top.has("march")) top.fail("march", "is of use only with 'method: march'");
  if (scene.march.form == BondForm::incremental) {
    top.fail(
        "method",
        "'solve' finds the equilibrium of the total form; the incremental one depends on its path: march");
  }
}

CantileverScene read_cantilever(const Section& top) {
  top.allow({"scene", "dimension", "fiber", "bond", "load", "method", "march"});
  CantileverScene scene{};
  if (top.has("dimension")) {
    scene.dimension = static_cast<Dimension>(top.choice("dimension", {"planar", "spatial"}));
  }
  scene.fiber = read_fiber(top);
  read_bond(top, scene);
  check_fiber(top, scene.fiber);
  read_load(top, scene);
  read_method(top, scene);
  return scene;
}

}  // namespace

SceneText read_scene_text(const std::filesystem::path& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  std::string text(kLargestScene + 1, '\0');
  const std::size_t size = file ? std::fread(text.data(), 1, text.size(), file.get()) : 0;
  if (!file || std::ferror(file.get())) {
    throw SceneError(fmt::format("{}: cannot read this scene: {}", path.string(), std::strerror(errno)));
  }
  if (size > kLargestScene) {
    throw SceneError(fmt::format("{}: is no scene: more than {} bytes", path.string(), kLargestScene));
  }
  text.resize(size);
  return {path.string(), std::move(text)};
}

Scene parse_scene(const SceneText& scene) {
  const Section top(scene.text, scene.name);
  top.choice("scene", {"cantilever"});
  return read_cantilever(top);
}

}  // namespace fiberchain::dem::io
