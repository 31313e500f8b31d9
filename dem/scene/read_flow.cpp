#include <fmt/format.h>

#include <cmath>

#include "dem/scene/read_common.hpp"

namespace fiberchain::dem {
namespace {

constexpr ValueRange kTolerance{.low = 1e-13, .high = 0.1};
constexpr ValueRange kBend{.low = -0.2, .high = 0.2};

/// A scene, and the length of its run as typed.
struct FlowKeys : FlowScene {
  std::optional<double> length_in_time, length_in_strain;  ///< [s], [-]
};

/// Mapping "start" as typed.
struct StartKeys {
  std::array<double, 3> direction{};
  double bend = FlowStart{}.bend, s_bend = FlowStart{}.s_bend;
  std::optional<std::array<double, 3>> bend_direction;
};

KeyTable<StartKeys> start_keys() {
  KeyTable<StartKeys> table;
  table.direction("direction", &StartKeys::direction, "direction of the fiber; its center is at the origin")
      .required();
  table.number("bend", &StartKeys::bend, kBend,
               "height of a parabola through the fiber's ends, over its length");
  table.number("s_bend", &StartKeys::s_bend, kBend,
               "height of the ends of a cubic over the fiber's line, over its length");
  table
      .direction("bend_direction", &StartKeys::bend_direction,
                 "direction of the bend, its part across the fiber")
      .otherwise("across the fiber in the plane; needed for a bend in space");
  return table;
}

/// Unit vector of the part of `across` that is across the unit vector `along`; zero where they are parallel.
std::array<double, 3> part_across(const std::array<double, 3>& along, std::array<double, 3> across) {
  const double part = along[0] * across[0] + along[1] * across[1] + along[2] * across[2];
  for (int i = 0; i < 3; ++i) across[i] -= part * along[i];
  const double length = std::hypot(across[0], across[1], across[2]);
  for (double& component : across) component = length > 1e-9 ? component / length : 0.0;
  return across;
}

std::array<double, 3> bend_direction_of(const StrictMapping& start, const StartKeys& keys,
                                        Dimension dimension) {
  const std::array<double, 3>& along = keys.direction;
  if (keys.bend_direction) {
    check_planar(start, "bend_direction", *keys.bend_direction, dimension);
    const std::array<double, 3> across = part_across(along, *keys.bend_direction);
    if (across == std::array<double, 3>{}) start.fail("bend_direction", "must not lie along the fiber");
    return across;
  }
  if (dimension == Dimension::planar) return {-along[1], along[0], 0};
  if (keys.bend != 0 || keys.s_bend != 0) {
    start.fail("", "key 'bend_direction' is missing: in space a bend needs a direction across the fiber");
  }
  return part_across(
      along, std::abs(along[0]) < 0.7 ? std::array<double, 3>{1, 0, 0} : std::array<double, 3>{0, 1, 0});
}

void store_start(const StrictMapping& start, const StartKeys& keys, FlowKeys& flow) {
  check_planar(start, "direction", keys.direction, flow.dimension);
  flow.start = {keys.direction, keys.bend, keys.s_bend, bend_direction_of(start, keys, flow.dimension)};
}

KeyTable<FlowOptions> flow_motion_keys() {
  KeyTable<FlowOptions> table;
  const auto leapfrog = [](const FlowOptions& options) { return is_leapfrog(options.method); };
  table.choice("method", &FlowOptions::method,
               words_of({FlowMethod::inertialess, FlowMethod::cvode, FlowMethod::leapfrog,
                         FlowMethod::leapfrog_stiff}),
               "balance of forces without inertia, or with inertia: implicit, explicit in the bonds, or with "
               "the bonds solved within the step");
  table.number("tolerance", &FlowOptions::tolerance, kTolerance, "local error, relative to L and to 1 rad")
      .only_with("method: inertialess or cvode",
                 [=](const FlowOptions& options) { return !leapfrog(options); });
  table
      .number("step_ratio", &FlowOptions::step_ratio, kStepRatio,
              "time step over the bond's t_b = sqrt(m / K_n)")
      .otherwise("0.8 of the largest stable step; leapfrog-stiff: what turning, tension and bending allow")
      .only_with("method: leapfrog or leapfrog-stiff", leapfrog);
  table.flag("allow_unstable", &FlowOptions::allow_unstable, "march even beyond the stable step")
      .only_with("method: leapfrog or leapfrog-stiff", leapfrog);
  return table;
}

void store_flow_fluid(const StrictMapping& mapping, const FluidKeys& keys, FlowKeys& flow) {
  const FluidInFlow in = fluid_of(mapping, keys, flow.dimension);
  flow.fluid = in.fluid;
  flow.rate = in.rate;
  flow.shear = in.shear;
}

KeyTable<FlowKeys> flow_keys() {
  KeyTable<FlowKeys> table;
  const auto store_bond = [](const BondKeys& keys, FlowKeys& flow) { flow.motion.form = keys.form; };
  const auto all = {Hydrodynamics::free_draining, Hydrodynamics::interactions, Hydrodynamics::stresslets};
  const auto motion = [](FlowKeys& flow) -> FlowOptions& { return flow.motion; };
  table.known("scene", "flow", "a free fiber carried, turned and bent by a creeping flow");
  declare_single_fiber(table, {.form = table.defaults().motion.form}, store_bond);
  table.mapping("fluid", fluid_keys(all, false), &store_flow_fluid, "the fluid and its flow").required();
  table.mapping("start", start_keys(), &store_start, "the fiber at the start").required();
  table.mapping_into("motion", motion, flow_motion_keys(), "integration in time");
  table.quantity("duration", "s", &FlowKeys::length_in_time, kPositive, "length of the run");
  table.number("strain", &FlowKeys::length_in_strain, {.low = 1e-9, .high = 1e9},
               "the same as a strain: time times the size of the rate, or the gradient's Frobenius norm");
  table.one_of({"duration", "strain"});
  table.integer("samples", &FlowKeys::samples, {.low = 2, .high = 1e6}, "intervals of the history");
  table.integer("shapes", &FlowKeys::shapes, {.low = 1, .high = 1000}, "intervals of the recorded shapes");
  return table;
}

/// What the method asked for cannot do.
void check_together(const StrictMapping& top, const FlowScene& scene) {
  const FlowMethod method = scene.motion.method;
  if (!scene.fiber.branches.empty())
    top.fail_within("material_damping", "is not built for a fiber in a fluid");
  if (scene.fiber.spacing != 1)
    top.fail_within("spacing", fmt::format("{:g} is not allowed in a fluid: its drag is that of spheres that "
                                           "touch; allowed: 1",
                                           scene.fiber.spacing));
  if (scene.fluid.hydrodynamics != Hydrodynamics::free_draining && method != FlowMethod::inertialess) {
    top.fail("fluid",
             "hydrodynamics: interactions and stresslets are built for method: inertialess; leapfrog and "
             "cvode have free_draining");
  }
  if (scene.motion.form == BondForm::incremental && !is_leapfrog(method)) {
    top.fail("bond",
             "form: incremental is built for method: leapfrog and leapfrog-stiff; inertialess and cvode have "
             "form: total");
  }
}

}  // namespace

std::vector<KeyDeclaration> flow_declarations() { return flow_keys().declarations(); }

FlowScene read_flow(const StrictMapping& top) {
  FlowKeys keys = flow_keys().read_strictly(top);
  keys.duration = keys.length_in_time ? *keys.length_in_time : keys.length_in_strain.value() / keys.rate;
  if (!std::isfinite(keys.duration)) top.fail("strain", "is too large for this rate");
  check_together(top, keys);
  return keys;
}

}  // namespace fiberchain::dem
