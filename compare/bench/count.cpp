#include "compare/bench/count.hpp"

#include <utility>
#include <vector>

#include "compare/bench/swinging_chain.hpp"
#include "dem/chain/chain_bond.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/kernels/chain_kernel.hpp"
#include "dem/motion/leapfrog.hpp"
#include "dem/motion/relaxation.hpp"

namespace fiberchain::compare {
namespace {

constexpr int steps_before = 600;  // past the load's ramp
constexpr int steps_counted = 100;

/// The types of the inner loop consist of numbers only: the same type on another number, value by value.
template <class To, class From>
To counted(const From& from, OperationCount* count) {
  To to;
  const double* source = dem::as_numbers<double>(from);
  Counted* target = dem::as_numbers<Counted>(to);
  static_assert(dem::numbers_of<To, Counted> == dem::numbers_of<From>);
  for (std::size_t i = 0; i < dem::numbers_of<From>; ++i) target[i] = Counted(source[i], count);
  return to;
}

template <int Dim>
dem::MarchParameters<double, Dim> parameters_of(const SwingingChain<Dim>& swing, bool fluid) {
  const dem::Fiber& fiber = swing.chain.fiber;
  dem::MarchParameters<double, Dim> p{};
  p.bond = dem::bond_parameters(fiber);
  p.inverse_length = 1 / dem::bond_length(fiber);
  dem::set_step(p, fiber, fluid ? dem::stokes_drag(swing.fluid, fiber) : dem::StokesDrag{}, swing.step);
  p.drag = swing.drag;
  p.rolling_arm = fiber.rolling_friction * dem::sphere_radius(fiber) / 2;
  p.ramp.last_to.force = swing.load.force;
  p.ramp.rate = 1 / swing.ramp_steps;
  return p;
}

/// What bonds with branches keep, and the branches in this step.
template <dem::Physics P>
class CountedMemory {
 public:
  static constexpr int Dim = P.dimension;

  CountedMemory(const SwingingChain<Dim>& swing, OperationCount* count) {
    if constexpr (P.branches) {
      steps_ = dem::branch_steps(swing.chain.fiber, swing.step, Dim);
      for (const auto& step : steps_.steps)
        counted_.push_back(counted<dem::BranchStep<Counted>>(step, nullptr));
      constexpr std::size_t history = dem::numbers_of<dem::HistoryOf<P, double>>;
      size_ = dem::memory_view<Dim>(steps_, nullptr, P.form, history).bond;
      const auto rest = dem::at_rest<Dim>(swing.chain.poses);
      for (int i = 0; i < kernel_bonds; ++i) {
        std::vector<double> numbers(size_, 0.0);
        dem::put_strided(dem::start_history<dem::BondLaw<P>>(swing.chain, rest, i), numbers.data(), 1);
        for (const double number : numbers) memory_.emplace_back(number, count);
      }
    }
  }

  void put(dem::ChainBlock<P, Counted>& block) {
    if constexpr (P.branches) {
      block.branches = {counted_.data(), steps_.stretch, steps_.shear, steps_.twist, steps_.bend};
      block.memory = memory_.data();
      block.bond_memory = size_;
    }
  }

 private:
  dem::BranchSteps steps_;
  std::vector<dem::BranchStep<Counted>> counted_;
  std::vector<Counted> memory_;
  std::size_t size_ = 0;
};

template <dem::Physics P>
OperationCount counted_bond_step() {
  constexpr int Dim = P.dimension;
  const SwingingChain<Dim> swing = swinging_chain_of<Dim>(P);
  OperationCount count;
  std::vector<dem::MovingSphere<Counted, Dim>> spheres;
  for (const auto& pose : swing.chain.poses) {
    dem::MovingSphere<double, Dim> sphere{};
    sphere.pose = pose;
    spheres.push_back(counted<dem::MovingSphere<Counted, Dim>>(sphere, &count));
  }
  std::vector<dem::HistoryOf<P, Counted>> history(
      kernel_bonds, counted<dem::HistoryOf<P, Counted>>(dem::HistoryOf<P, double>{}, &count));
  std::vector<dem::NaturalEnds<Counted, Dim>> natural;
  for (const auto& ends : swing.chain.natural)
    natural.push_back(counted<dem::NaturalEnds<Counted, Dim>>(ends, &count));
  std::vector<Counted> workspace(dem::workspace_reals<P, Counted>(kernel_bonds));
  CountedMemory<P> memory(swing, &count);
  // parameters without a count: what is made of them alone is made before the loop
  dem::ChainBlock<P, Counted> block{
      kernel_bonds,    {true, false},
      spheres.data(),  history.data(),
      natural.data(),  counted<dem::MarchParameters<Counted, Dim>>(parameters_of(swing, P.fluid), nullptr),
      workspace.data()};
  memory.put(block);
  std::vector<Counted> gradient;  // steady: without a count too
  for (int c = 0; c < Dim * Dim; ++c)
    gradient.emplace_back(swing.fluid.flow.gradient[c / Dim][c % Dim], nullptr);
  const auto flow = dem::local_flow<P>(gradient.data());
  dem::start_march<P, Counted>(block);
  for (int n = 0; n < steps_before; ++n) dem::march_step<P, Counted>(block, n, flow);
  count = {};
  for (int n = 0; n < steps_counted; ++n) dem::march_step<P, Counted>(block, steps_before + n, flow);
  return count / (steps_counted * kernel_bonds);
}

template <std::size_t... I>
OperationCount counted_bond_step(const dem::Physics& physics, std::index_sequence<I...>) {
  OperationCount count;
  const bool found =
      ((physics == dem::built_physics[I] && (count = counted_bond_step<dem::built_physics[I]>(), true)) ||
       ...);
  if (!found) throw dem::InvalidInput("operations are counted only for a physics that is built");
  return count;
}

}  // namespace

OperationCount operator/(const OperationCount& c, double number) {
  return {c.additions / number,    c.multiplications / number, c.fusable / number,     c.divisions / number,
          c.square_roots / number, c.sines / number,           c.arc_tangents / number};
}

OperationCount operations_of_bond_step(const dem::Physics& physics) {
  return counted_bond_step(physics, std::make_index_sequence<dem::built_physics.size()>{});
}

}  // namespace fiberchain::compare
