#include "compare/friction/stretch_march.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/measure/linear_chain_of.hpp"
#include "dem/equilibrium/newton.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "reference/chain_modes.hpp"

namespace fiberchain::compare {
namespace {

using Block = dem::ChainBatch<2>;

Block let_go(const dem::Fiber& fiber, const dem::Poses<2>& start, double dt) {
  const dem::Chain<2> chain = dem::straight_chain<2>(fiber);
  Block block({chain}, {true, false}, {dt}, {0.0}, {2, dem::BondForm::incremental, true, false, false},
              dem::InstructionSet::scalar);
  const auto bond = dem::bond_parameters(fiber);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    auto sphere = block.sphere(0, i);
    sphere.pose = start[i];
    block.set_sphere(0, i, sphere);
  }
  for (int i = 0; i < fiber.aspect_ratio; ++i) {
    const auto k = dem::bond_kinematics(chain, start, i);
    block.set_history(0, i,
                      dem::history_of(bond, start[i + 1].position - start[i].position,
                                      dem::bond_loads(k, dem::bond_stress(bond, k.separation, k.rotation))));
  }
  block.synchronize();
  return block;
}

double stretch_from_length(const Block& block, int bond, double rest_length) {
  return dem::norm(block.sphere(0, bond + 1).pose.position - block.sphere(0, bond).pose.position) -
         rest_length;
}

void record(TipHistory& history, const Block& block, const dem::Fiber& fiber, double time, double dt) {
  const auto tip = block.sphere(0, fiber.aspect_ratio);
  const double L = dem::fiber_length(fiber);
  history.time.push_back(time);
  history.y.push_back(tip.pose.position[1] / L);
  history.velocity.push_back((tip.velocity[1] + 0.5 * dt / dem::sphere_mass(fiber) * tip.force[1]) / L);
}

}  // namespace

StretchComparison compare_stretch(const dem::Fiber& fiber, double load, double step_ratio, PeakRange peaks) {
  const double dt = step_ratio * dem::bond_time_step(fiber), l = dem::bond_length(fiber);
  const auto mode = reference::first_bending_mode(linear_chain_of(fiber));
  const double period = 2 * std::numbers::pi / mode.eigenvalue.imag();
  const dem::Load<2> end{fiber.aspect_ratio, {0, dem::load_force(fiber, load)}, {}};
  const auto start =
      dem::solve_equilibrium(dem::straight_chain<2>(fiber), dem::Boundary<2>{{0}, {end}}).poses;
  Block by_increments = let_go(fiber, start, dt), by_length = let_go(fiber, start, dt);
  TipHistory increments, length;
  double largest = 0, difference = 0, tips = 0;
  const int steps = static_cast<int>((peaks.last + 0.9) * period / dt);
  for (int n = 0; n <= steps; ++n) {
    record(increments, by_increments, fiber, n * dt, dt);
    record(length, by_length, fiber, n * dt, dt);
    const auto apart = by_increments.sphere(0, fiber.aspect_ratio).pose.position -
                       by_length.sphere(0, fiber.aspect_ratio).pose.position;
    tips = std::max(tips, dem::norm(apart) / dem::fiber_length(fiber));
    for (int i = 0; i < fiber.aspect_ratio; ++i) {
      const double exact = stretch_from_length(by_increments, i, l);
      largest = std::max(largest, std::abs(exact));
      difference = std::max(difference, std::abs(by_increments.history(0, i).stretch - exact));
      auto history = by_length.history(0, i);
      history.stretch = stretch_from_length(by_length, i, l);
      by_length.set_history(0, i, history);
    }
    by_increments.march(1);
    by_length.march(1);
  }
  const double damping = damping_from_peaks(positive_peaks(length), peaks).ratio;
  return {difference / largest, tips,
          damping_from_peaks(positive_peaks(increments), peaks).ratio / damping - 1};
}

}  // namespace fiberchain::compare
