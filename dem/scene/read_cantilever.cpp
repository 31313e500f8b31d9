#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

KeyTable<RelaxOptions> march_keys() {
  KeyTable<RelaxOptions> table;
  table.number("bond_damping", &RelaxOptions::bond_damping, kCoefficient,
               "damping ratio ξ_b while settling, in place of the fiber's own");
  table.number("drag", &RelaxOptions::drag, kCoefficient,
               "drag on every sphere over the critical one of the first bending mode");
  table
      .number("step_ratio", &RelaxOptions::step_ratio, kStepRatio,
              "time step over the bond's t_b = sqrt(m / K_n)")
      .otherwise("0.8 of the largest stable step");
  table.number("ramp_periods", &RelaxOptions::ramp_periods, {.low = 0, .high = 1e6},
               "length of the load's ramp in periods of the first bending mode");
  table.number(
      "residual", &RelaxOptions::residual, {.low = 1e-12, .high = 1, .high_open = true},
      "at rest: moment out of balance and speeds, over those of the load and the first mode, below this");
  table.number("max_periods", &RelaxOptions::max_periods, {.low = 1e-3, .high = 1e6},
               "limit of the march, in periods of the first bending mode after the ramp");
  return table;
}

void store_march(const StrictMapping& mapping, const RelaxOptions& options, CantileverScene& scene) {
  if (options.bond_damping == 0 && options.drag == 0) {
    mapping.fail("", "needs bond_damping or drag above 0 to come to rest");
  }
  const BondForm form = scene.march.form;
  scene.march = options;
  scene.march.form = form;
}

KeyTable<CantileverScene> cantilever_keys() {
  KeyTable<CantileverScene> table;
  table.known("scene", "cantilever",
              "a straight fiber, clamped at its first sphere, under a dead load at its last");
  declare_single_fiber(table, {.form = table.defaults().march.form},
                       [](const BondKeys& keys, CantileverScene& scene) { scene.march.form = keys.form; });
  const auto store_load = [](const StrictMapping& mapping, const LoadKeys& keys, CantileverScene& scene) {
    const EndPull pull = pull_of(mapping, keys, scene.fiber, scene.dimension);
    scene.load = pull.load;
    scene.direction = pull.direction;
  };
  table.mapping("load", load_keys(), store_load, "the load at the free end").required();
  table.choice(
      "method", &CantileverScene::method, words_of({Method::solve, Method::march}),
      "Newton's method (`form: total` only), or dynamic relaxation under a load ramp as the paper does");
  table.flag("allow_unstable", &CantileverScene::allow_unstable,
             "answer with an unstable equilibrium, too: the one on the path from zero load");
  table
      .vector("gravity", "m/s^2", &CantileverScene::gravity,
              "acceleration of gravity, which gives every sphere a weight")
      .only_with("'method: solve'",
                 [](const CantileverScene& scene) { return scene.method == Method::solve; });
  table.mapping("march", march_keys(), &store_march, "dynamic relaxation")
      .only_with("'method: march'",
                 [](const CantileverScene& scene) { return scene.method == Method::march; });
  return table;
}

}  // namespace

std::vector<KeyDeclaration> cantilever_declarations() { return cantilever_keys().declarations(); }

CantileverScene read_cantilever(const StrictMapping& top) {
  const CantileverScene scene = cantilever_keys().read_strictly(top);
  if (scene.method == Method::solve && scene.march.form == BondForm::incremental) {
    top.fail(
        "method",
        "'solve' finds the equilibrium of the total form; the incremental one depends on its path: march");
  }
  check_planar(top, "gravity", scene.gravity, scene.dimension);
  return scene;
}

}  // namespace fiberchain::dem
