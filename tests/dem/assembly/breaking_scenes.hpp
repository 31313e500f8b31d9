#pragma once

#include <functional>
#include <vector>

#include "tests/dem/assembly/assembly_scenes.hpp"

/// Fibers that break, for tests.
namespace scenes {

/// A free straight fiber whose spheres have moved by displacements and turned by rotation vectors.
inline dem::ChainState<3> strained(const dem::Chain<3>& chain, const std::function<V(int)>& displacement,
                                   const std::function<V(int)>& turn) {
  dem::ChainState<3> state = dem::at_rest<3>(chain.poses);
  for (int i = 0; i <= chain.fiber.aspect_ratio; ++i) {
    state.poses[i].position = state.poses[i].position + displacement(i);
    state.poses[i].orientation = dem::rotation(turn(i)) * state.poses[i].orientation;
  }
  return state;
}

/// One bond: its two spheres so far from each other, each turned to one side.
struct OneBond {
  double stretch = 0;  ///< over the bond's length
  V bend{};            ///< rotation vector of the second against the first
  double shear = 0;    ///< turn of both about z
};

inline dem::FiberGroup one_bond(const dem::Fiber& fiber, const OneBond& strain) {
  const dem::Chain<3> chain = dem::straight_chain<3>(fiber);
  return {chain,
          {strained(
              chain,
              [&](int i) {
                return V{(i - 0.5) * strain.stretch * dem::bond_length(fiber), 0, 0};
              },
              [&](int i) {
                return (i - 0.5) * strain.bend + V{0, 0, strain.shear};
              })}};
}

/// A state of an assembly's fiber from a sphere to another.
inline dem::ChainState<3> part_of(const dem::ChainState<3>& state, int first, int last) {
  dem::ChainState<3> part;
  for (int i = first; i <= last; ++i) {
    part.poses.push_back(state.poses[i]);
    part.velocity.push_back(state.velocity[i]);
    part.spin.push_back(state.spin[i]);
  }
  return part;
}

}  // namespace scenes
