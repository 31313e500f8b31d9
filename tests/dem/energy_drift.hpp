#pragma once

#include <algorithm>
#include <vector>

#include "tests/dem/free_motion.hpp"
#include "tests/dem/marching_chains.hpp"

/// A free, undamped, rotating, bent and twisted chain watched for many steps.
namespace marching {

struct EnergyDrift {
  std::vector<double> mean;  ///< of energy / first energy - 1 in ten equal parts of the run
  double largest;            ///< |energy / first energy - 1|
  double momentum, angular;  ///< drift over its size
};

/// The same chain at several time steps, given over the largest stable one, side by side.
template <int Dim>
std::vector<EnergyDrift> energy_drift(dem::BondForm form, const std::vector<double>& step_ratios,
                                      double steps, double speed, dem::BondModel bond = dem::BondModel::paper,
                                      unsigned seed = 9) {
  const dem::Fiber fiber{dem::isotropic_material(3.7e5, 0.3, 431), 0.0262, 4, bond};
  const std::vector<dem::Chain<Dim>> chains(step_ratios.size(), dem::straight_chain<Dim>(fiber));
  std::vector<double> dt = step_ratios;
  for (double& step : dt) step *= dem::stable_time_step(fiber);
  dem::ChainBatch<Dim> block(
      chains, {false, false}, dt, std::vector<double>(dt.size(), 0.0),
      {.dimension = Dim, .form = form, .damped = false, .settling_damping = false, .curved = false},
      dem::best_instruction_set());
  for (std::size_t lane = 0; lane < dt.size(); ++lane) {
    // one seed for all: stir() would give each lane its own
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    const double rate = speed / dem::bond_time_step(fiber);
    dem::Vec<double, Dim> sum{};
    for (int i = 0; i <= fiber.aspect_ratio; ++i) {
      auto sphere = block.sphere(static_cast<int>(lane), i);
      for (double& c : sphere.velocity.c) c = rate * dem::bond_length(fiber) * normal(generator);
      for (double& c : sphere.spin.c) c = rate * normal(generator);
      sum = sum + sphere.velocity;
      block.set_sphere(static_cast<int>(lane), i, sphere);
    }
    // at rest as a whole, or it leaves the origin and its angular momentum is a small difference of large
    // numbers
    for (int i = 0; i <= fiber.aspect_ratio; ++i) {
      auto sphere = block.sphere(static_cast<int>(lane), i);
      sphere.velocity = sphere.velocity - (1.0 / (fiber.aspect_ratio + 1)) * sum;
      block.set_sphere(static_cast<int>(lane), i, sphere);
    }
  }
  block.synchronize();
  const auto energy = [&](int lane) {
    return kinetic_energy(block, fiber, dt[lane], lane) + elastic_energy(block, chains[lane], form, lane);
  };
  const int lanes = static_cast<int>(dt.size());
  std::vector<double> start;
  std::vector<Account<Dim>> before;
  for (int lane = 0; lane < lanes; ++lane) {
    start.push_back(energy(lane));
    before.push_back(account(block, fiber, lane));
  }
  std::vector<EnergyDrift> drift(dt.size(), {{}, 0, 0, 0});
  // a prime: not in step with any vibration
  const int looks = static_cast<int>(std::clamp(steps / 10 / 97, 100.0, 10000.0));
  const int between = static_cast<int>(steps / 10 / looks);
  for (int part = 0; part < 10; ++part) {
    std::vector<double> sum(dt.size(), 0.0);
    for (int look = 0; look < looks; ++look) {
      block.march(between);
      for (int lane = 0; lane < lanes; ++lane) {
        const double off = energy(lane) / start[lane] - 1;
        sum[lane] += off;
        drift[lane].largest = std::max(drift[lane].largest, std::abs(off));
      }
    }
    for (int lane = 0; lane < lanes; ++lane) drift[lane].mean.push_back(sum[lane] / looks);
  }
  for (int lane = 0; lane < lanes; ++lane) {
    const Account<Dim> after = account(block, fiber, lane);
    drift[lane].momentum = momentum_drift(before[lane], after);
    drift[lane].angular = angular_drift(before[lane], after);
  }
  return drift;
}

}  // namespace marching
