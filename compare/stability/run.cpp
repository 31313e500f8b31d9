#include "compare/stability/run.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/physics_of.hpp"

namespace fiberchain::compare {
namespace {

constexpr int together = 8;  // steps tried at once

template <int Dim>
dem::Physics physics_of(const StabilityRun& run) {
  return dem::physics_of(
      dem::straight_chain<Dim>(run.fiber),
      {.form = run.form, .solved = run.scheme == dem::Integrator::leapfrog_damped ? dem::Solved::dashpots : dem::Solved::nothing});
}

template <int Dim>
void stir(dem::ChainBatch<Dim>& block, const dem::Fiber& fiber, int lane) {
  std::mt19937 generator(276);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double rate = 1e-9 / dem::bond_time_step(fiber);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    auto sphere = block.sphere(lane, i);
    for (double& v : sphere.velocity.c) v = rate * dem::bond_length(fiber) * uniform(generator);
    for (double& w : sphere.spin.c) w = rate * uniform(generator);
    block.set_sphere(lane, i, sphere);
  }
}

/// Root mean square over the spheres of velocity and l times spin.
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

/// Marches the lanes of one block; stops when all have grown.
template <int Dim>
std::vector<bool> block_grows(const StabilityRun& run, const std::vector<double>& time_steps, int steps) {
  const int lanes = static_cast<int>(time_steps.size());
  const std::vector<dem::Chain<Dim>> chains(time_steps.size(), dem::straight_chain<Dim>(run.fiber));
  const dem::Clamps clamps{run.ends == reference::ChainEnds::clamped_free, false};
  dem::ChainBatch<Dim> block(chains, clamps, time_steps, std::vector<double>(time_steps.size(), 0.0),
                             physics_of<Dim>(run), dem::best_instruction_set());
  for (int lane = 0; lane < lanes; ++lane) stir(block, run.fiber, lane);
  const double start = speed(block, run.fiber, 0);
  std::vector<bool> grew(time_steps.size(), false);
  constexpr int between_looks = 500;
  for (int done = 0; done < steps && !std::ranges::all_of(grew, std::identity{}); done += between_looks) {
    block.march(std::min(between_looks, steps - done));
    for (int lane = 0; lane < lanes; ++lane) {
      if (!(speed(block, run.fiber, lane) < grown * start)) grew[lane] = true;
    }
  }
  return grew;
}

int lanes_of_block(const StabilityRun& run) {
  const dem::Physics physics = run.dimension == 2 ? physics_of<2>(run) : physics_of<3>(run);
  return dem::chain_kernel(physics, dem::best_instruction_set()).width;
}

/// Narrows to the last that was stable before the first that grew. If the lowest grew that was stable before,
/// in fewer steps, the lower end moves down by `retreat`.
void narrow(MeasuredLimit& limit, const std::vector<double>& tried, const std::vector<bool>& grew,
            double retreat) {
  const auto first = static_cast<std::size_t>(std::ranges::find(grew, true) - grew.begin());
  limit.stable = first > 0 ? tried[first - 1] : tried[0] / retreat;
  if (first < tried.size()) limit.unstable = tried[first];
  limit.ordered = limit.ordered && std::ranges::is_sorted(grew);
}

}  // namespace

std::vector<bool> motion_grows(const StabilityRun& run, const std::vector<double>& time_steps, int steps) {
  const auto width = static_cast<std::size_t>(lanes_of_block(run));
  std::vector<bool> all;
  for (std::size_t first = 0; first < time_steps.size(); first += width) {
    const std::vector<double> part(time_steps.begin() + first,
                                   time_steps.begin() + std::min(first + width, time_steps.size()));
    const auto grew =
        run.dimension == 2 ? block_grows<2>(run, part, steps) : block_grows<3>(run, part, steps);
    all.insert(all.end(), grew.begin(), grew.end());
  }
  return all;
}

int steps_to_grow(const StabilityRun& run, double excess) {
  const bool lagged = run.scheme == dem::Integrator::leapfrog;
  const double sensitivity = lagged ? 2 : std::min(2.0, 0.8 / std::max(run.fiber.bond_damping, 1e-9));
  // what grows is at least a part 1/sqrt(unknowns) of a random motion
  const double unknowns = 6.0 * (run.fiber.aspect_ratio + 1);
  return static_cast<int>(std::log(grown * std::sqrt(unknowns)) / std::log1p(sensitivity * excess)) + 100;
}

MeasuredLimit measured_limit(const StabilityRun& run, double width) {
  dem::check(run.fiber);
  MeasuredLimit limit{0, 2.5 * dem::bond_time_step(run.fiber), 0, true};
  bool verified = false;  // that the lower end is stable, for as many steps as the width asks for
  const auto look = [&](double lowest, double ratio) {
    std::vector<double> tried;
    for (int i = 0; i < together; ++i) tried.push_back(lowest * std::pow(ratio, i));
    const double excess = std::clamp((ratio - 1) / 2, width / 2, 0.1);
    const int steps = steps_to_grow(run, excess);
    const std::vector<bool> grew = motion_grows(run, tried, steps);
    narrow(limit, tried, grew, std::max(ratio, 1 + width));
    limit.steps += steps * static_cast<double>(tried.size());
    verified = excess == width / 2 && !grew[0];
    return !grew[0];
  };
  while (!look(limit.unstable / std::ldexp(1.0, together), 2.0)) continue;
  while (!verified || limit.unstable > (1 + width) * limit.stable) {
    look(limit.stable, std::pow(limit.unstable / limit.stable, 1.0 / together));
  }
  return limit;
}

}  // namespace fiberchain::compare
