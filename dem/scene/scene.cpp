#include "dem/scene/scene.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "dem/model/errors.hpp"
#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

void read_march(const StrictMapping& top, RelaxOptions& march) {
  constexpr ValueRange kFraction{.low = 0, .high = 1, .low_open = true, .high_open = true};
  const StrictMapping section =
      top.section("march", {"bond_damping", "drag", "step_ratio", "ramp_periods", "residual", "max_periods"});
  const auto read = [&](const char* key, double& value, const ValueRange& allowed) {
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

void read_method(const StrictMapping& top, CantileverScene& scene) {
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

CantileverScene read_cantilever(const StrictMapping& top) {
  top.allow({"scene", "dimension", "fiber", "bond", "load", "method", "march"});
  CantileverScene scene{};
  scene.dimension = read_dimension(top);
  scene.fiber = read_fiber(top);
  if (top.has("bond")) read_bond(top.section("bond", {"model", "form", "damping"}), scene.fiber, scene.march.form);
  check_fiber(top, scene.fiber);
  const EndPull pull = read_load(top, scene.fiber, scene.dimension);
  scene.load = pull.load;
  scene.direction = pull.direction;
  read_method(top, scene);
  return scene;
}

}  // namespace

SceneText read_scene_text(const std::filesystem::path& path, std::size_t largest) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  std::string text(largest + 1, '\0');
  const std::size_t size = file ? std::fread(text.data(), 1, text.size(), file.get()) : 0;
  if (!file || std::ferror(file.get())) {
    throw SceneError(fmt::format("{}: cannot read this scene: {}", path.string(), std::strerror(errno)));
  }
  if (size > largest) {
    throw SceneError(fmt::format("{}: is no scene: more than {} bytes", path.string(), largest));
  }
  text.resize(size);
  return {path.string(), std::move(text)};
}

Scene parse_scene(const SceneText& scene) {
  const StrictMapping top(scene.text, scene.name);
  switch (top.choice("scene", {"cantilever", "release", "flow", "packing"})) {
    case 0: return read_cantilever(top);
    case 1: return read_release(top);
    case 2: return read_flow(top);
    default: return read_packing(top);
  }
}

}  // namespace fiberchain::dem
