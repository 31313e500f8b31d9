#pragma once

#include <random>
#include <vector>

#include "dem/motion/lanes/block.hpp"
#include "dem/motion/time_step.hpp"

/// Free and clamped chains in wild motion, for tests of the inner loops.
namespace marching {

namespace dem = fiberchain::dem;

inline dem::Fiber odd_fiber(unsigned seed, double damping) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> factor(0.7, 1.4), nu(-0.1, 0.45);
  return {dem::isotropic_material(3.7e5 * factor(generator), nu(generator), 431.0 * factor(generator)),
          0.0262 * factor(generator), 13, seed % 2 ? dem::BondModel::corrected : dem::BondModel::paper, damping};
}

template <int Dim>
dem::Chain<Dim> odd_chain(unsigned seed, double damping, bool curved) {
  const dem::Fiber fiber = odd_fiber(seed, damping);
  return curved ? dem::cornered_chain<Dim>(fiber, 5) : dem::straight_chain<Dim>(fiber);
}

/// Every sphere gets its own velocity and spin, fast enough to bend the chain by tens of degrees.
template <int Dim>
void stir(dem::MarchingBlock<Dim>& block, const std::vector<dem::Chain<Dim>>& chains, unsigned seed, double speed) {
  for (std::size_t lane = 0; lane < chains.size(); ++lane) {
    std::mt19937 generator(seed + 97 * static_cast<unsigned>(lane));
    std::normal_distribution<double> normal;
    const dem::Fiber& fiber = chains[lane].fiber;
    const double scale = speed * dem::bond_length(fiber) / dem::bond_time_step(fiber);
    for (int i = 0; i <= fiber.aspect_ratio; ++i) {
      auto sphere = block.sphere(static_cast<int>(lane), i);
      for (double& c : sphere.velocity.c) c = scale * normal(generator);
      for (double& c : sphere.spin.c) c = scale / dem::bond_length(fiber) * normal(generator);
      block.set_sphere(static_cast<int>(lane), i, sphere);
    }
  }
}

template <int Dim>
dem::MarchingBlock<Dim> block_of(const std::vector<dem::Chain<Dim>>& chains, dem::Clamps clamps,
                                 const dem::Physics& physics, dem::InstructionSet set) {
  std::vector<double> steps, drag;
  for (const auto& chain : chains) {
    drag.push_back(0.01 / dem::bond_time_step(chain.fiber));
    steps.push_back(0.5 * dem::stable_time_step(chain.fiber, drag.back()));
  }
  return dem::MarchingBlock<Dim>(chains, clamps, steps, drag, physics, set);
}

}  // namespace marching
