#pragma once

#include <random>
#include <vector>

#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/time_step.hpp"

/// Free and clamped chains in wild motion, for tests of the inner loops.
namespace marching {

namespace dem = fiberchain::dem;

inline dem::Fiber odd_fiber(unsigned seed, double damping) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> factor(0.7, 1.4), nu(-0.1, 0.45);
  return {dem::isotropic_material(3.7e5 * factor(generator), nu(generator), 431.0 * factor(generator)),
          0.0262 * factor(generator), 13, seed % 2 ? dem::BondModel::corrected : dem::BondModel::paper,
          damping};
}

template <int Dim>
dem::Chain<Dim> odd_chain(unsigned seed, double damping, bool curved) {
  const dem::Fiber fiber = odd_fiber(seed, damping);
  return curved ? dem::cornered_chain<Dim>(fiber, 5) : dem::straight_chain<Dim>(fiber);
}

/// Every sphere gets its own velocity and spin, fast enough to bend the chain by tens of degrees.
template <int Dim>
void stir(dem::ChainBatch<Dim>& block, const std::vector<dem::Chain<Dim>>& chains, unsigned seed,
          double speed) {
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

/// An unsteady flow of its own for every lane, which moves a chain by about its length in 200 steps.
template <int Dim>
dem::Fluid odd_fluid(const dem::Fiber& fiber) {
  const double lane = fiber.diameter / 0.0262;  // differs from fiber to fiber
  const double t_b = dem::bond_time_step(fiber),
               viscosity = (0.05 + 0.03 * lane) * dem::sphere_mass(fiber) / t_b;
  dem::Gradient A{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) A[i][j] = (0.004 * (1 + i) - 0.003 * j * (1 + lane)) / t_b;
  }
  A[1][1] = -A[0][0];
  if (Dim == 3) A[0][2] = 0.005 / t_b, A[2][1] = -0.002 / t_b, A[2][2] = 0.001 / t_b, A[0][0] -= A[2][2];
  return {viscosity / dem::sphere_radius(fiber), dem::oscillation(A, (90 + 20 * lane) * t_b, 0.3)};
}

/// A load and moment on every sphere.
template <int Dim>
dem::Boundary<Dim> odd_loads(const dem::Fiber& fiber) {
  dem::Boundary<Dim> boundary;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    dem::Load<Dim> load{i, {}, {}};
    for (double& c : load.force.c) c = dem::load_force(fiber, 0.1 + 0.03 * i);
    for (double& c : load.moment.c) c = dem::load_force(fiber, 0.2 - 0.07 * i) * dem::bond_length(fiber);
    boundary.loads.push_back(load);
  }
  return boundary;
}

template <int Dim>
dem::ChainBatch<Dim> block_of(const std::vector<dem::Chain<Dim>>& chains, dem::Clamps clamps,
                              const dem::Physics& physics, dem::InstructionSet set) {
  std::vector<double> steps, drag;
  for (const auto& chain : chains) {
    drag.push_back(0.01 / dem::bond_time_step(chain.fiber));
    steps.push_back(0.5 * dem::stable_time_step(chain.fiber, drag.back()));
  }
  dem::ChainBatch<Dim> block(chains, clamps, steps, drag, physics, set);
  for (int lane = 0; physics.fluid && lane < block.lanes(); ++lane) {
    block.set_fluid(lane, odd_fluid<Dim>(chains[lane].fiber));
    block.set_loads(lane, odd_loads<Dim>(chains[lane].fiber));
  }
  return block;
}

}  // namespace marching
