#include "compare/packing/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/study/errors.hpp"
#include "dem/material/flat_loss.hpp"

namespace fiberchain::compare {
namespace {

using Vec3 = dem::Vec<double, 3>;

constexpr double kLowest = 0.02;                       // of the fibers at the start [m]
constexpr double kColumn = 2000 / (0.1 * 0.1 * 0.36);  // fibers in a volume then [1/m^3]
constexpr double kSpeed = 1;                           // downward [m/s]

double youngs_modulus(const PackingCase& asked) { return asked.stiffness * 2.6e6; }  // [Pa]

/// E and G are the storage moduli in the middle of the band.
void set_loss_factor(double loss_factor, dem::Fiber& fiber) {
  const dem::PronySeries series = dem::flat_loss(loss_factor, kPackingBand).series;
  const double relaxed = dem::relaxed_part(series, std::sqrt(kPackingBand.low * kPackingBand.high));
  fiber.material.across = dem::contact_elasticity(fiber.material);
  fiber.material.youngs_modulus *= relaxed, fiber.material.shear_modulus *= relaxed;
  fiber.branches = dem::maxwell_branches({series, series, {}}, fiber.bond_model);
}

dem::Fiber fiber_of(const PackingCase& asked) {
  dem::Fiber fiber{dem::isotropic_material(youngs_modulus(asked), 0.3, 1000), 0.002, 20};
  fiber.bond_damping = asked.bond_damping;
  fiber.rolling_friction = asked.rolling_friction;
  if (asked.loss_factor > 0) set_loss_factor(asked.loss_factor, fiber);
  return fiber;
}

dem::Domain room_of(double side, const PackingCase& asked) {
  dem::Domain around;
  around.gravity = {0, 0, -9.81};
  around.contacts = {.restitution = 0.4, .friction = 0.6};
  if (asked.contact_modulus != 1)
    around.contacts.youngs_modulus = asked.contact_modulus * youngs_modulus(asked);
  around.wall_youngs_modulus = youngs_modulus(asked);
  around.walls.push_back({dem::Plane{{}, {0, 0, 1}}});
  if (asked.periodic) {
    around.period = {side, side, 0};
    return around;
  }
  for (const int axis : {0, 1}) {
    Vec3 normal{}, far{};
    normal[axis] = 1, far[axis] = side;
    around.walls.push_back({dem::Plane{{}, normal}});
    around.walls.push_back({dem::Plane{far, -1.0 * normal}});
  }
  return around;
}

/// Of the limits that bonds and contacts set. Fibers pressed into a corner are stable below 0.8 of the
/// contacts' only.
double step_of(const dem::PackingScene& scene) {
  const dem::FiberGroup group{dem::straight_chain<3>(scene.kinds.front().fiber), {}};
  const dem::StepChoice choice =
      dem::stable_time_step({group}, scene.domain, {.integrator = scene.integrator});
  return std::min(0.8 * dem::largest_bond_step(choice), 0.45 * choice.contacts);
}

}  // namespace

dem::PackingScene packing_scene(const PackingCase& asked) {
  if (asked.fibers < 1) throw InputError(fmt::format("a packing of {} fibers", asked.fibers));
  const double side = asked.side, highest = kLowest + asked.fibers / (kColumn * side * side);
  dem::PackingScene scene;
  scene.kinds = {{.fiber = fiber_of(asked), .count = asked.fibers}};
  scene.filling = {.region = {{0, 0, kLowest}, {side, side, highest}},
                   .velocity = {0, 0, -kSpeed},
                   .gap = 1e-4,
                   .seed = asked.seed};
  scene.domain = room_of(side, asked);
  scene.scene_box = {{0, 0, 0}, {side, side, highest}};
  scene.duration = asked.duration;
  scene.account_energy = asked.accounted;
  scene.integrator = asked.integrator;
  scene.step = asked.step_ratio * step_of(scene);
  return scene;
}

double floor_area(const dem::PackingScene& scene) {
  return (scene.scene_box.high[0] - scene.scene_box.low[0]) *
         (scene.scene_box.high[1] - scene.scene_box.low[1]);
}

}  // namespace fiberchain::compare
