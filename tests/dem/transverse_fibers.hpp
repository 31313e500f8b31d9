#pragma once

#include <cmath>
#include <limits>

#include "dem/assembly/assembly.hpp"
#include "dem/contact/contact_rates.hpp"
#include "dem/insertion/placement.hpp"
#include "reference/two_spheres.hpp"

/// Fibers of two spheres across the plane of motion: both spheres move alike, the bond carries nothing, and
/// each sphere does what it would do alone. The plane is tilted against all axes.
namespace transverse {

namespace dem = fiberchain::dem;
namespace ref = fiberchain::reference;
using V = dem::Vec<double, 3>;

constexpr double infinite = std::numeric_limits<double>::infinity();

inline const dem::Quaternion<double> tilt = dem::rotation({0.7, -1.9, 0.4});
inline V tilted(double x, double y, double z) { return rotate(tilt, V{x, y, z}); }
inline V untilted(const V& u) { return rotate(conjugate(tilt), u); }

inline dem::Fiber fiber_of(double youngs_modulus, double poisson_ratio, double density, double diameter) {
  return {dem::isotropic_material(youngs_modulus, poisson_ratio, density), diameter, 1};
}

inline ref::ElasticBody body_of(const dem::Fiber& fiber) {
  return {dem::sphere_radius(fiber), dem::sphere_mass(fiber), fiber.material.youngs_modulus,
          dem::poisson_ratio(fiber.material)};
}

inline ref::ElasticBody wall_of(const dem::Domain& around) {
  return {infinite, infinite, around.wall_youngs_modulus > 0 ? around.wall_youngs_modulus : infinite,
          around.wall_poisson_ratio};
}

/// At x, y in the tilted plane.
inline dem::FiberGroup group_of(const dem::Fiber& fiber, double x, double y,
                                const ref::PlanarMotion& motion) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  dem::ChainState<3> state = dem::placed(
      chain, {tilted(x, y, 0), tilted(0, 0, 1), tilted(motion.velocity[0], motion.velocity[1], 0)});
  state.spin.assign(2, tilted(0, 0, motion.spin));
  return {chain, {state}};
}

/// Of a sphere of the group's fiber.
inline ref::PlanarMotion motion_of(const dem::Assembly& assembly, int group, int sphere = 0) {
  const dem::ChainState<3> s = assembly.state(group, 0);
  const V v = untilted(s.velocity[sphere]);
  return {{v[0], v[1]}, untilted(s.spin[sphere])[2]};
}

inline V place_of(const dem::Assembly& assembly, int group, int sphere = 0) {
  return untilted(assembly.state(group, 0).poses[sphere].position);
}

/// What of a fiber's motion is not the same for both spheres, or leaves the plane: velocity and R spin [m/s].
inline double out_of_plane(const dem::Assembly& assembly, int group) {
  const dem::ChainState<3> s = assembly.state(group, 0);
  const double R = dem::sphere_radius(assembly.chain(group).fiber);
  const V w = untilted(s.spin[0]);
  return std::abs(untilted(s.velocity[0])[2]) + norm(s.velocity[1] - s.velocity[0]) +
         R * norm(s.spin[1] - s.spin[0]) + R * (std::abs(w[0]) + std::abs(w[1]));
}

}  // namespace transverse
