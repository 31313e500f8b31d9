#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

constexpr ValueRange kFraction{.low = 0, .high = 1, .low_open = true, .high_open = true};

const std::vector<std::string> kBondKeys = {"model", "form", "damping", "rolling_friction", "rolling"};

void read_release_bond(const StrictMapping& top, ReleaseScene& scene) {
  const StrictMapping section = top.section("bond", kBondKeys);
  read_bond(section, scene.fiber, scene.motion.form);
  if (section.has("rolling_friction")) {
    scene.fiber.rolling_friction = section.number("rolling_friction", kNonNegative);
  }
  if (section.has("rolling")) {
    const bool solved = section.choice("rolling", {"set_valued", "explicit_sign"}) == 0;
    scene.motion.rolling = solved ? Rolling::set_valued : Rolling::explicit_sign;
    if (scene.fiber.rolling_friction == 0) section.fail("rolling", "is of use only with rolling_friction above 0");
  }
}

Integrator read_integrator(const StrictMapping& time) {
  constexpr Integrator all[] = {Integrator::automatic, Integrator::leapfrog, Integrator::leapfrog_damped,
                                Integrator::implicit, Integrator::cvode};
  std::vector<std::string> words;
  for (const Integrator one : all) words.emplace_back(name(one));
  return all[time.choice("integrator", words)];
}

/// A key that only some integrators have a use for.
void only_with(const StrictMapping& time, const char* key, bool useful, const char* those) {
  if (time.has(key) && !useful) time.fail(key, std::string("is of use only with integrator: ") + those);
}

void read_time(const StrictMapping& top, ReleaseOptions& motion) {
  const StrictMapping time = top.section(
      "time", {"integrator", "error", "step_ratio", "allow_unstable", "tolerance", "samples_per_period"});
  if (time.has("integrator")) motion.integrator = read_integrator(time);
  const bool automatic = motion.integrator == Integrator::automatic, cvode = motion.integrator == Integrator::cvode;
  const bool leapfrog =
      motion.integrator == Integrator::leapfrog || motion.integrator == Integrator::leapfrog_damped;
  only_with(time, "error", automatic, "auto");
  only_with(time, "tolerance", cvode, "cvode");
  only_with(time, "step_ratio", !automatic && !cvode, "leapfrog, leapfrog-damped or implicit");
  only_with(time, "allow_unstable", leapfrog, "leapfrog or leapfrog-damped");
  if (time.has("error")) motion.error = time.number("error", kFraction);
  if (time.has("tolerance")) motion.tolerance = time.number("tolerance", kFraction);
  if (time.has("step_ratio")) motion.step_ratio = time.number("step_ratio", kPositive);
  if (time.has("allow_unstable")) motion.allow_unstable = time.choice("allow_unstable", {"false", "true"}) == 1;
  if (time.has("samples_per_period")) {
    motion.samples_per_period = time.integer("samples_per_period", {.low = 4, .high = 1e5});
  }
}

/// What the integrator asked for cannot do.
void check_together(const StrictMapping& top, const ReleaseScene& scene) {
  const Integrator integrator = scene.motion.integrator;
  const bool incremental = scene.motion.form == BondForm::incremental;
  if (scene.fiber.rolling_friction > 0) {
    if (integrator != Integrator::leapfrog && integrator != Integrator::automatic) {
      top.fail("time", "rolling friction is built for integrator: leapfrog (or auto)");
    }
    if (!incremental) top.fail("bond", "rolling friction is built for form: incremental");
  }
  const bool total_only = integrator == Integrator::implicit || integrator == Integrator::cvode;
  if (total_only && incremental && top.has("bond") && top.section("bond", kBondKeys).has("form")) {
    top.fail("bond", "form: incremental is built for the leapfrogs; implicit and cvode have form: total");
  }
}

}  // namespace

ReleaseScene read_release(const StrictMapping& top) {
  top.allow({"scene", "dimension", "fiber", "bond", "load", "periods", "time"});
  ReleaseScene scene{};
  scene.motion.integrator = Integrator::automatic;
  scene.dimension = read_dimension(top);
  scene.fiber = read_fiber(top);
  if (top.has("bond")) read_release_bond(top, scene);
  check_fiber(top, scene.fiber);
  scene.pull = read_load(top, scene.fiber, scene.dimension);
  if (scene.pull.load == 0) top.fail("load", "must not be zero: there would be nothing to watch");
  if (scene.pull.direction[1] == 0) top.fail("load", "needs a direction with a part along y, which is what is watched");
  if (top.has("periods")) scene.periods = top.number("periods", {.low = 0, .high = 1e6, .low_open = true});
  if (top.has("time")) read_time(top, scene.motion);
  check_together(top, scene);
  return scene;
}

}  // namespace fiberchain::dem
