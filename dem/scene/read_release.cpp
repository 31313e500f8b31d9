#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

bool is_leapfrog(const ReleaseOptions& motion) { return is_leapfrog(motion.integrator); }

KeyTable<ReleaseOptions> time_keys(const ReleaseOptions& defaults) {
  KeyTable<ReleaseOptions> table(defaults);
  const auto is = [](Integrator one) {
    return [one](const ReleaseOptions& motion) { return motion.integrator == one; };
  };
  table.choice("integrator", &ReleaseOptions::integrator,
               words_of({Integrator::automatic, Integrator::leapfrog, Integrator::leapfrog_damped,
                         Integrator::leapfrog_stiff, Integrator::implicit, Integrator::cvode}),
               "integration in time; `auto`: the cheapest that keeps `error`");
  table
      .number("error", &ReleaseOptions::error, {.low = 1e-9, .high = 1, .high_open = true},
              "wanted relative error of damping and frequency")
      .only_with("integrator: auto", is(Integrator::automatic));
  table
      .number("step_ratio", &ReleaseOptions::step_ratio, kStepRatio,
              "time step over the bond's t_b = sqrt(m / K_n)")
      .otherwise(
          "0.8 of the largest stable step; `implicit` and `leapfrog-stiff`: the sample interval, or what "
          "tension "
          "and turning allow")
      .only_with("integrator: leapfrog, leapfrog-damped, leapfrog-stiff or implicit",
                 [](const ReleaseOptions& motion) {
                   return is_leapfrog(motion) || motion.integrator == Integrator::implicit;
                 });
  table.flag("allow_unstable", &ReleaseOptions::allow_unstable, "march even beyond the stable step")
      .only_with("integrator: leapfrog, leapfrog-damped or leapfrog-stiff",
                 [](const ReleaseOptions& motion) { return is_leapfrog(motion); });
  table
      .number("tolerance", &ReleaseOptions::tolerance, {.low = 1e-13, .high = 1, .high_open = true},
              "local error over the first deflection")
      .only_with("integrator: cvode", is(Integrator::cvode));
  table.integer("samples_per_period", &ReleaseOptions::samples_per_period, {.low = 4, .high = 1e5},
                "samples of the free end in a period of the first mode");
  return table;
}

/// What the integrator asked for cannot do.
void check_together(const StrictMapping& top, const ReleaseScene& scene) {
  const Integrator integrator = scene.motion.integrator;
  check_branches(top, scene.fiber);
  if (!scene.fiber.branches.empty() && integrator != Integrator::automatic &&
      integrator != Integrator::leapfrog && integrator != Integrator::leapfrog_stiff)
    top.fail("time", "material_damping is built for integrator: leapfrog and leapfrog-stiff (or auto)");
  const bool incremental = scene.motion.form == BondForm::incremental;
  if (scene.fiber.rolling_friction > 0) {
    if (integrator != Integrator::leapfrog && integrator != Integrator::automatic) {
      top.fail("time", "rolling friction is built for integrator: leapfrog (or auto)");
    }
    if (!incremental) top.fail("bond", "rolling friction is built for form: incremental");
  }
  const bool total_only = integrator == Integrator::implicit || integrator == Integrator::cvode;
  if (total_only && incremental && top.has("bond") && top.mapping("bond").has("form")) {
    top.fail("bond", "form: incremental is built for the leapfrogs; implicit and cvode have form: total");
  }
}

KeyTable<ReleaseScene> release_keys() {
  ReleaseScene defaults{};
  defaults.motion.integrator = Integrator::automatic;
  KeyTable<ReleaseScene> table(defaults);
  table.known("scene", "release", "the cantilever held under its load, then let go");
  const auto store_bond = [](const BondKeys& keys, ReleaseScene& scene) {
    scene.motion.form = keys.form;
    scene.motion.rolling = keys.rolling;
  };
  declare_single_fiber(table, {table.defaults().motion.form, true, true}, store_bond);
  const auto store_load = [](const StrictMapping& mapping, const LoadKeys& keys, ReleaseScene& scene) {
    scene.pull = pull_of(mapping, keys, scene.fiber, scene.dimension);
    if (scene.pull.load == 0) mapping.fail("", "must not be zero: there would be nothing to watch");
    if (scene.pull.direction[1] == 0)
      mapping.fail("", "needs a direction with a part along y, which is what is watched");
  };
  table.mapping("load", load_keys(), store_load, "the load at the free end before the release").required();
  table.number("periods", &ReleaseScene::periods, {.low = 1e-6, .high = 1e6},
               "length of the record in periods of the first mode");
  table.mapping_into("time", &ReleaseScene::motion, time_keys(table.defaults().motion),
                     "integration in time");
  return table;
}

}  // namespace

std::vector<KeyDeclaration> release_declarations() { return release_keys().declarations(); }

ReleaseScene read_release(const StrictMapping& top) {
  const ReleaseScene scene = release_keys().read_strictly(top);
  check_together(top, scene);
  return scene;
}

}  // namespace fiberchain::dem
