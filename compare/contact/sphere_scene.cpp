#include "compare/contact/sphere_scene.hpp"

#include <algorithm>
#include <cmath>

#include "dem/insertion/placement.hpp"
#include "dem/math/quaternion.hpp"

namespace fiberchain::compare {
namespace {

using Vec3 = dem::Vec<double, 3>;

const dem::Quaternion<double> kTilt = dem::rotation(Vec3{0.7, -1.9, 0.4});
Vec3 tilted(double x, double y, double z) { return rotate(kTilt, Vec3{x, y, z}); }
Vec3 untilted(const Vec3& u) { return rotate(conjugate(kTilt), u); }

/// Of two spheres, joined by bonds of `share` of the material's modulus.
dem::Fiber fiber_of(const ImpactBody& body, double share) {
  dem::Material material =
      dem::isotropic_material(share * body.youngs_modulus, body.poisson_ratio, body.density);
  material.across = dem::TransverseElasticity{body.youngs_modulus, body.poisson_ratio};
  return {material, 2 * body.radius, 1};
}

dem::FiberGroup group_of(const dem::Fiber& fiber, double x, double y, const reference::PlanarMotion& motion) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  dem::ChainState<3> state = dem::placed(
      chain, {tilted(x, y, 0), tilted(0, 0, 1), tilted(motion.velocity[0], motion.velocity[1], 0)});
  state.spin.assign(state.poses.size(), tilted(0, 0, motion.spin));
  return {chain, {state}};
}

}  // namespace

SphereScene sphere_scene(const ImpactCase& impact, double bonds, double lead) {
  SphereScene scene;
  const reference::PlanarMotion &one = impact.first_motion, &two = impact.second_motion;
  const double R = impact.first.radius;
  scene.groups.push_back(
      group_of(fiber_of(impact.first, bonds), -R - lead * one.velocity[0], -lead * one.velocity[1], one));
  if (impact.second) {
    const double x = impact.second->radius - lead * two.velocity[0];
    scene.groups.push_back(group_of(fiber_of(*impact.second, bonds), x, -lead * two.velocity[1], two));
  } else {
    scene.domain.walls = {{dem::Plane{{}, tilted(-1, 0, 0)}, {}}};
  }
  scene.domain.contacts.restitution = impact.restitution;
  scene.domain.contacts.friction = impact.friction;
  return scene;
}

reference::PlanarMotion motion_of(const dem::Assembly& assembly, int group) {
  const dem::ChainState<3> s = assembly.state(group, 0);
  const Vec3 v = untilted(s.velocity[0]);
  return {{v[0], v[1]}, untilted(s.spin[0])[2]};
}

double gap_of(const dem::Assembly& assembly, const ImpactCase& impact) {
  const Vec3 x = assembly.state(0, 0).poses[0].position;
  if (!impact.second) return -untilted(x)[0] - impact.first.radius;
  return norm(assembly.state(1, 0).poses[0].position - x) - impact.first.radius - impact.second->radius;
}

double peak_of(const std::vector<double>& values) {
  const auto at = std::ranges::max_element(values) - values.begin();
  if (at == 0 || at + 1 == std::ssize(values)) return values[at];
  const double slope = (values[at + 1] - values[at - 1]) / 2,
               bend = values[at + 1] - 2 * values[at] + values[at - 1];
  return values[at] - 0.5 * slope * slope / bend;
}

std::optional<dem::ContactState> contact_of(const dem::Assembly& assembly) {
  for (const dem::ContactState& contact : assembly.contacts()) {
    if (contact.key.first.number == 0) return contact;
  }
  return std::nullopt;
}

double along(const dem::Vec<double, 3>& vector) { return untilted(vector)[0]; }

}  // namespace fiberchain::compare
