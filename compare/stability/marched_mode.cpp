#include "compare/stability/marched_mode.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "compare/measure/linear_chain_of.hpp"
#include "compare/stability/stirred.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "reference/chain_modes.hpp"

namespace fiberchain::compare {
namespace {

std::complex<double> root_of(const std::vector<double>& u) {
  double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
  for (std::size_t n = 1; n + 1 < u.size(); ++n) {
    aa += u[n] * u[n], ab += u[n] * u[n - 1], bb += u[n - 1] * u[n - 1];
    ac += u[n] * u[n + 1], bc += u[n - 1] * u[n + 1];
  }
  const double det = aa * bb - ab * ab, sum = (ac * bb - bc * ab) / det, square = (ab * ac - aa * bc) / det;
  return {sum / 2, std::sqrt(square - sum * sum / 4)};
}

reference::ChainMode undamped_mode(const ModeRun& run) {
  reference::LinearChain chain = linear_chain_of(run.chain.fiber);
  chain.dashpot = {0, 0, 0, 0};
  return reference::chain_modes(chain, reference::ChainMotion::bending, run.chain.ends).at(run.mode);
}

}  // namespace

double MarchedMode::damping_error() const {
  const std::complex<double> exponent = std::log(z);
  return -exponent.real() / std::abs(exponent) / damping - 1;
}

double MarchedMode::frequency_error() const { return std::abs(std::log(z)) / angle - 1; }

MarchedMode marched_mode(const ModeRun& run) {
  const dem::Fiber& fiber = run.chain.fiber;
  const reference::ChainMode mode = undamped_mode(run);
  const double angle = 2 * std::numbers::pi * run.part_of_period, dt = angle / mode.frequency;
  const dem::Clamps clamps{run.chain.ends == reference::ChainEnds::clamped_free, false};
  dem::ChainBatch<2> block({dem::straight_chain<2>(fiber)}, clamps, {dt}, {0.0}, planar_physics(run.chain),
                           dem::best_instruction_set());
  const double rate = 1e-6 * dem::bond_length(fiber) * std::min(mode.frequency, 1 / dt);
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    auto sphere = block.sphere(0, i);
    sphere.velocity.c[1] = rate * mode.displacement[i].real();
    sphere.spin.c[0] = rate * mode.rotation[i].real();
    block.set_sphere(0, i, sphere);
  }
  std::vector<double> end;
  for (int i = 0; i < run.steps; ++i) {
    block.march(1);
    end.push_back(block.sphere(0, fiber.aspect_ratio).pose.position.c[1]);
  }
  return {root_of(end), angle, fiber.retardation_time * mode.frequency / 2};
}

}  // namespace fiberchain::compare
