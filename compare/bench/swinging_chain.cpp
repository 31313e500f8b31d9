#include "compare/bench/swinging_chain.hpp"

#include <fmt/format.h>
#include <cmath>
#include <memory>

#include "compare/static/case.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::compare {
namespace {

using dem::InstructionSet;
using dem::Physics;

template <int Dim>
std::function<void()> swinging(const Physics& physics, InstructionSet set, int chains, int steps) {
  const SwingingChain<Dim> timed = swinging_chain_of<Dim>(physics);
  const auto n = static_cast<std::size_t>(chains);
  const auto block = std::make_shared<dem::ChainBatch<Dim>>(
      std::vector(n, timed.chain), dem::Clamps{true, false}, std::vector(n, timed.step),
      std::vector(n, timed.drag), physics, set);
  for (int lane = 0; lane < chains; ++lane) {
    block->set_ramp(lane, {}, {{0}, {timed.load}}, timed.ramp_steps);
    if (physics.fluid) block->set_fluid(lane, timed.fluid);
  }
  return [=] {
    block->march(steps);
    if (!std::isfinite(block->sphere(0, kernel_bonds).pose.position[1]))
      throw dem::Diverged("a timed chain diverged");
  };
}

}  // namespace

dem::Fiber kernel_fiber() { return nominal_fiber(kernel_bonds, 0.3, dem::BondModel::paper); }

template <int Dim>
SwingingChain<Dim> swinging_chain_of(const Physics& physics) {
  dem::Fiber fiber = kernel_fiber();
  fiber.bond_damping = physics.damped ? 0.5 : 0.0;
  if (physics.branches) {
    for (int j = 0; j < kernel_branches; ++j)
      fiber.branches.bend.push_back({0.02, std::pow(4.0, j) * 10 * dem::bond_time_step(fiber)});
  }
  fiber.rolling_friction = physics.rolling == dem::Rolling::none ? 0.0 : 0.5;
  const double drag = physics.settling_damping ? 1e-3 / dem::bond_time_step(fiber) : 0.0;
  // drag and shear that slow and bend the swing a little
  const double t_b = dem::bond_time_step(fiber);
  const dem::Fluid fluid{1e-4 * dem::sphere_mass(fiber) / (dem::sphere_radius(fiber) * t_b),
                         {dem::simple_shear(1e-5 / t_b)}};
  dem::Load<Dim> load{kernel_bonds, {}, {}};
  load.force[1] = dem::load_force(fiber, 0.5);
  return {
      physics.curved ? dem::cornered_chain<Dim>(fiber, kernel_bonds / 2) : dem::straight_chain<Dim>(fiber),
      0.5 * dem::stable_time_step(fiber, drag),
      drag,
      load,
      500,
      fluid};
}

template SwingingChain<2> swinging_chain_of<2>(const Physics&);
template SwingingChain<3> swinging_chain_of<3>(const Physics&);

std::string text(const Physics& p) {
  std::string all = fmt::format("{} {}", p.dimension == 2 ? "planar" : "spatial", dem::name(p.form));
  if (p.solved == dem::Solved::bonds) {
    all += " bonds in the step";
  } else if (p.damped) {
    all += p.solved == dem::Solved::dashpots ? " damped in the step" : " damped";
  }
  if (p.settling_damping) all += " drag";
  if (p.fluid) all += " in fluid";
  if (p.curved) all += " curved";
  if (p.branches) all += fmt::format(" {} branches in bending", kernel_branches);
  if (p.rolling != dem::Rolling::none) all += fmt::format(" rolling {}", dem::name(p.rolling));
  return all;
}

std::function<void()> swinging_chains(const Physics& physics, InstructionSet set, int chains, int steps) {
  return physics.dimension == 2 ? swinging<2>(physics, set, chains, steps)
                                : swinging<3>(physics, set, chains, steps);
}

}  // namespace fiberchain::compare
