#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "dem/assembly/assembly.hpp"
#include "dem/insertion/placement.hpp"
#include "dem/math/quaternion.hpp"

/// Fibers and domain for tests of assemblies, by no round numbers.
namespace scenes {

namespace dem = fiberchain::dem;
using V = dem::Vec<double, 3>;

inline dem::Fiber odd_fiber(int bonds, double size = 1) {
  return {dem::isotropic_material(3.7e5, 0.17, 431.0), 0.0262 * size, bonds};
}

/// A chain whose rest shape turns by the rotation vector `turn` (in the sphere's frame) from sphere to
/// sphere.
inline dem::Chain<3> curled(const dem::Fiber& fiber, const V& turn) {
  dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  const dem::Quaternion<double> half = dem::rotation(0.5 * turn);
  for (int i = 1; i <= fiber.aspect_ratio; ++i) {
    const auto& before = chain.poses[i - 1];
    const auto middle = before.orientation * half;
    chain.poses[i] = {before.position + dem::rotate(middle, V{dem::bond_length(fiber), 0, 0}), middle * half};
  }
  chain.natural.assign(fiber.aspect_ratio, {half, dem::conjugate(half)});
  return chain;
}

inline void move(dem::ChainState<3>& state, const V& by) {
  for (auto& pose : state.poses) pose.position = pose.position + by;
}

/// Fibers along random directions on a plane grid of cells too large for them to meet; every sphere with a
/// velocity and a spin of its own, `speed` diameters in t_b.
inline dem::FiberGroup scattered(const dem::Chain<3>& chain, int count, double speed, unsigned seed) {
  dem::FiberGroup group{chain, {}};
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return V{normal(random), normal(random), normal(random)}; };
  const double cell = (chain.fiber.aspect_ratio + 3) * chain.fiber.diameter;
  const double rate = speed / dem::bond_time_step(chain.fiber);
  for (int f = 0; f < count; ++f) {
    const auto turn = dem::normalized(dem::Quaternion<double>{normal(random), vector()});
    dem::ChainState<3> state = dem::placed(chain, turn, {f % 4 * cell, f / 4 * cell, 0}, {});
    for (std::size_t i = 0; i < state.poses.size(); ++i) {
      state.velocity[i] = rate * chain.fiber.diameter * vector();
      state.spin[i] = rate * vector();
    }
    group.fibers.push_back(state);
  }
  return group;
}

struct Momenta {
  V linear{}, angular{};
  double linear_size = 0, angular_size = 0;  ///< sums of the sizes of each sphere's
};

/// Of every sphere of every fiber.
inline Momenta momenta(const dem::Assembly& assembly) {
  Momenta sum;
  for (int g = 0; g < assembly.groups(); ++g) {
    const dem::Fiber& fiber = assembly.chain(g).fiber;
    for (const dem::ChainState<3>& state : assembly.states(g)) {
      for (std::size_t i = 0; i < state.velocity.size(); ++i) {
        const double share = dem::mass_share(fiber, static_cast<int>(i));
        const V p = share * dem::sphere_mass(fiber) * state.velocity[i],
                L = cross(state.poses[i].position, p) + share * dem::sphere_inertia(fiber) * state.spin[i];
        sum.linear = sum.linear + p, sum.angular = sum.angular + L;
        sum.linear_size += norm(p), sum.angular_size += norm(L);
      }
    }
  }
  return sum;
}

}  // namespace scenes
