#include <cmath>

#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

constexpr ValueRange kTolerance{.low = 1e-13, .high = 0.1};
constexpr ValueRange kBend{.low = -0.2, .high = 0.2};

/// Unit vector of what `across` has across the unit vector `along`; nothing is left if they are parallel.
std::array<double, 3> part_across(const std::array<double, 3>& along, std::array<double, 3> across) {
  const double part = along[0] * across[0] + along[1] * across[1] + along[2] * across[2];
  for (int i = 0; i < 3; ++i) across[i] -= part * along[i];
  const double length = std::hypot(across[0], across[1], across[2]);
  for (double& component : across) component = length > 1e-9 ? component / length : 0.0;
  return across;
}

void read_start(const StrictMapping& top, FlowScene& scene) {
  const StrictMapping start = top.section("start", {"direction", "bend", "s_bend", "bend_direction"});
  FlowStart& s = scene.start;
  s.direction = read_direction(start, "direction", scene.dimension);
  if (start.has("bend")) s.bend = start.number("bend", kBend);
  if (start.has("s_bend")) s.s_bend = start.number("s_bend", kBend);
  if (start.has("bend_direction")) {
    s.bend_direction = part_across(s.direction, read_direction(start, "bend_direction", scene.dimension));
    if (s.bend_direction == std::array<double, 3>{})
      start.fail("bend_direction", "must not lie along the fiber");
  } else if (scene.dimension == Dimension::planar) {
    s.bend_direction = {-s.direction[1], s.direction[0], 0};
  } else if (s.bend != 0 || s.s_bend != 0) {
    start.fail("", "key 'bend_direction' is missing: in space a bend needs a direction across the fiber");
  } else {
    s.bend_direction =
        part_across(s.direction, std::abs(s.direction[0]) < 0.7 ? std::array<double, 3>{1, 0, 0}
                                                                : std::array<double, 3>{0, 1, 0});
  }
}

FlowMethod read_method(const StrictMapping& motion) {
  constexpr FlowMethod all[] = {FlowMethod::inertialess, FlowMethod::cvode, FlowMethod::leapfrog};
  std::vector<std::string> words;
  for (const FlowMethod one : all) words.emplace_back(name(one));
  return all[motion.choice("method", words)];
}

/// A key that only some methods have a use for.
void only_with(const StrictMapping& motion, const char* key, bool useful, const char* those) {
  if (motion.has(key) && !useful) motion.fail(key, std::string("is of use only with method: ") + those);
}

void read_motion(const StrictMapping& top, FlowOptions& options) {
  const StrictMapping motion = top.section("motion", {"method", "tolerance", "step_ratio", "allow_unstable"});
  if (motion.has("method")) options.method = read_method(motion);
  const bool leapfrog = options.method == FlowMethod::leapfrog;
  only_with(motion, "tolerance", !leapfrog, "inertialess or cvode");
  only_with(motion, "step_ratio", leapfrog, "leapfrog");
  only_with(motion, "allow_unstable", leapfrog, "leapfrog");
  if (motion.has("tolerance")) options.tolerance = motion.number("tolerance", kTolerance);
  if (motion.has("step_ratio")) options.step_ratio = motion.number("step_ratio", kPositive);
  if (motion.has("allow_unstable")) {
    options.allow_unstable = motion.choice("allow_unstable", {"false", "true"}) == 1;
  }
}

double read_duration(const StrictMapping& top, double rate) {
  if (top.one_of({"duration", "strain"}) == "duration") return top.quantity("duration", "s", kPositive);
  return top.number("strain", kPositive) / rate;
}

/// What the method asked for cannot do.
void check_together(const StrictMapping& top, const FlowScene& scene) {
  const FlowMethod method = scene.motion.method;
  if (scene.fluid.hydrodynamics != Hydrodynamics::free_draining && method != FlowMethod::inertialess) {
    top.fail("fluid",
             "hydrodynamics: interactions and stresslets are built for method: inertialess; leapfrog and "
             "cvode have free_draining");
  }
  if (scene.motion.form == BondForm::incremental && method != FlowMethod::leapfrog) {
    top.fail("bond",
             "form: incremental is built for method: leapfrog; inertialess and cvode have form: total");
  }
}

}  // namespace

FlowScene read_flow(const StrictMapping& top) {
  top.allow({"scene", "dimension", "fiber", "bond", "fluid", "start", "motion", "duration", "strain",
             "samples", "shapes"});
  FlowScene scene{};
  scene.dimension = read_dimension(top);
  scene.fiber = read_fiber(top);
  if (top.has("bond"))
    read_bond(top.section("bond", {"model", "form", "damping"}), scene.fiber, scene.motion.form);
  check_fiber(top, scene.fiber);
  read_fluid(top, scene);
  read_start(top, scene);
  if (top.has("motion")) read_motion(top, scene.motion);
  scene.duration = read_duration(top, scene.rate);
  if (!std::isfinite(scene.duration)) top.fail("strain", "is too large for this rate");
  if (top.has("samples")) scene.samples = top.integer("samples", {.low = 2, .high = 1e6});
  if (top.has("shapes")) scene.shapes = top.integer("shapes", {.low = 1, .high = 1000});
  check_together(top, scene);
  return scene;
}

}  // namespace fiberchain::dem
