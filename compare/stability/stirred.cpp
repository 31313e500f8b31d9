#include "compare/stability/stirred.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/physics_of.hpp"

namespace fiberchain::compare {
namespace {

template <int Dim>
dem::Physics physics_of(const StabilityRun& run) {
  return dem::physics_of(dem::straight_chain<Dim>(run.fiber),
                         {.form = run.form, .solved = dem::solved_by(run.scheme)});
}

template <int Dim>
void stir(dem::ChainBatch<Dim>& block, const dem::Fiber& fiber, int lane, double rate) {
  std::mt19937 generator(276);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    auto sphere = block.sphere(lane, i);
    for (double& v : sphere.velocity.c) v = rate * dem::bond_length(fiber) * uniform(generator);
    for (double& w : sphere.spin.c) w = rate * uniform(generator);
    block.set_sphere(lane, i, sphere);
  }
}

template <int Dim>
double speed(const dem::ChainBatch<Dim>& block, const dem::Fiber& fiber, int lane) {
  const double l = dem::bond_length(fiber);
  double sum = 0;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const auto sphere = block.sphere(lane, i);
    sum += dem::dot(sphere.velocity, sphere.velocity) + l * l * dem::dot(sphere.spin, sphere.spin);
  }
  return std::sqrt(sum / (fiber.aspect_ratio + 1));
}

template <int Dim>
void march(const StabilityRun& run, const std::vector<StirredLane>& lanes, int steps, int between,
           const std::function<bool(const std::vector<double>& speeds)>& go_on) {
  const std::vector<dem::Chain<Dim>> chains(lanes.size(), dem::straight_chain<Dim>(run.fiber));
  std::vector<double> time_steps;
  for (const StirredLane& lane : lanes) time_steps.push_back(lane.time_step);
  const dem::Clamps clamps{run.ends == reference::ChainEnds::clamped_free, false};
  dem::ChainBatch<Dim> block(chains, clamps, time_steps, std::vector<double>(lanes.size(), 0.0),
                             physics_of<Dim>(run), dem::best_instruction_set());
  std::vector<double> start;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    stir(block, run.fiber, static_cast<int>(i), lanes[i].rate);
    start.push_back(speed(block, run.fiber, static_cast<int>(i)));
  }
  std::vector<double> speeds(lanes.size(), 1.0);
  for (int done = 0; done < steps && go_on(speeds); done += between) {
    block.march(std::min(between, steps - done));
    for (std::size_t i = 0; i < lanes.size(); ++i)
      speeds[i] = speed(block, run.fiber, static_cast<int>(i)) / start[i];
  }
  go_on(speeds);
}

}  // namespace

dem::Physics planar_physics(const StabilityRun& run) { return physics_of<2>(run); }

int lanes_of_block(const StabilityRun& run) {
  const dem::Physics physics = run.dimension == 2 ? physics_of<2>(run) : physics_of<3>(run);
  return dem::chain_kernel(physics, dem::best_instruction_set()).width;
}

void march_stirred(const StabilityRun& run, const std::vector<StirredLane>& lanes, int steps, int between,
                   const std::function<bool(const std::vector<double>& speeds)>& go_on) {
  run.dimension == 2 ? march<2>(run, lanes, steps, between, go_on)
                     : march<3>(run, lanes, steps, between, go_on);
}

}  // namespace fiberchain::compare
