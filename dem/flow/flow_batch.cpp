#include "dem/flow/flow_batch.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "dem/flow/stretch_limit.hpp"
#include "dem/motion/kernels/chain_lane.hpp"
#include "dem/motion/physics_of.hpp"

namespace fiberchain::dem {
namespace {

/// Steps between two looks at the whole chain: long enough that looking costs little.
constexpr int steps_between_looks = 256;

/// The step that leads to the first time after the start; any serves where there is none.
double first_step(const FlowPlan& plan) {
  const auto first = std::ranges::find_if(plan.counts, [](double count) { return count > 0; });
  return first == plan.counts.end() ? plan.stable : plan.lengths[first - plan.counts.begin()];
}

template <int Dim>
ChainBatch<Dim> block_of(const std::vector<typename FlowBatch<Dim>::Member>& members,
                         const FlowOptions& options) {
  std::vector<Chain<Dim>> chains;
  std::vector<double> steps;
  for (const auto& member : members) {
    chains.push_back(member.flow->chain);
    steps.push_back(first_step(member.plan));
  }
  const Physics physics = physics_of<Dim>(
      chains, {.form = options.form,
               .solved = options.method == FlowMethod::leapfrog_stiff ? Solved::bonds : Solved::nothing,
               .fluid = true});
  return {chains,  members[0].plan.clamps, steps, std::vector<double>(chains.size(), 0.0),
          physics, options.instruction_set};
}

template <int Dim>
std::string failure_text(const FlowCase<Dim>& flow, int sphere, double step, double dt, double time,
                         double stable) {
  const std::string cause =
      dt >= stable ? fmt::format("the step is beyond the stable one, {:.6g} s", stable)
                   : fmt::format("{}; a load far beyond the bonds' stiffness, or a step too long for it",
                                 stretch_cause(flow.chain.fiber, flow.fluid, time));
  return fmt::format(
      "the run blew up: sphere {} at step {:.0f} (dt = {:.6g} s, t = {:.6g} s); likely cause: {}", sphere,
      step, dt, time, cause);
}

}  // namespace

template <int Dim>
FlowBatch<Dim>::FlowBatch(std::vector<Member> members, const FlowOptions& options)
    : members_(std::move(members)), block_(block_of<Dim>(members_, options)) {
  for (std::size_t lane = 0; lane < members_.size(); ++lane) {
    const FlowCase<Dim>& flow = *members_[lane].flow;
    const int number = static_cast<int>(lane);
    block_.set_fluid(number, flow.fluid);
    block_.set_loads(number, flow.boundary);
    put_state(block_, number, flow.chain, carried_state(flow));
    lanes_.push_back({first_step(members_[lane].plan)});
  }
  block_.synchronize();
}

template <int Dim>
std::vector<FlowRecord> FlowBatch<Dim>::run(const FlowJobSample<Dim>& sample) {
  const int spheres = members_[0].flow->chain.fiber.aspect_ratio + 1;
  for (std::size_t n = 0; n < members_[0].times->size(); ++n) {
    const double steps = members_[0].plan.counts[n];
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
      if (steps > 0) take_step(lane, members_[lane].plan.lengths[n]);
    }
    for (double done = 0; done < steps; done += steps_between_looks) {
      stretch(static_cast<int>(std::min<double>(steps - done, steps_between_looks)));
    }
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
      if (!whole(lane)) continue;
      const double time = (*members_[lane].times)[n];
      const FlowCase<Dim>& flow = *members_[lane].flow;
      const ChainState<Dim> state =
          time > 0 ? state_now(block_, static_cast<int>(lane), spheres) : carried_state(flow);
      if (lanes_[lane].step < members_[lane].plan.stable)
        lanes_[lane].record.failure = stretch_failure(flow.chain, state.poses, flow.fluid, time);
      if (!whole(lane)) continue;
      lanes_[lane].time = lanes_[lane].record.reached = time;
      sample(lane, time, state);
    }
  }
  std::vector<FlowRecord> records;
  for (const Lane& lane : lanes_) records.push_back(lane.record);
  return records;
}

/// Equal intervals differ by the rounding of their ends; that is not worth another step.
template <int Dim>
void FlowBatch<Dim>::take_step(std::size_t lane, double step) {
  Lane& own = lanes_[lane];
  if (!whole(lane)) return;
  if (std::abs(step - own.step) > 1e-12 * own.step) {
    block_.set_step(static_cast<int>(lane), step);
    own.step = step;
  }
  own.record.time_step = std::max(own.record.time_step, step);
}

template <int Dim>
void FlowBatch<Dim>::stretch(int steps) {
  if (std::ranges::none_of(lanes_, [](const Lane& lane) { return lane.record.failure.empty(); })) return;
  const std::vector<double> saved = block_.saved();
  block_.march(steps);
  for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
    if (!whole(lane)) continue;
    if (broken_sphere(block_, static_cast<int>(lane), members_[lane].flow->chain.fiber) < 0) {
      count(lane, steps);
      continue;
    }
    const std::vector<double> now = block_.saved();
    block_.restore(saved);
    find_break(lane, steps);
    block_.restore(now);
  }
}

template <int Dim>
void FlowBatch<Dim>::count(std::size_t lane, int steps) {
  Lane& own = lanes_[lane];
  own.record.work.steps += steps;
  own.record.work.bond_evaluations +=
      static_cast<double>(steps) * members_[lane].flow->chain.fiber.aspect_ratio;
  own.time += steps * own.step;
}

/// Goes over a stretch that broke the chain again, step by step, from where all was well.
template <int Dim>
void FlowBatch<Dim>::find_break(std::size_t lane, int steps) {
  Lane& own = lanes_[lane];
  for (int n = 1; n <= steps && whole(lane); ++n) {
    own.record.reached = own.time;
    block_.march(1);
    count(lane, 1);
    const int sphere = broken_sphere(block_, static_cast<int>(lane), members_[lane].flow->chain.fiber);
    if (sphere < 0) continue;
    own.record.failure = failure_text(*members_[lane].flow, sphere, own.record.work.steps, own.step, own.time,
                                      members_[lane].plan.stable);
  }
}

template class FlowBatch<2>;
template class FlowBatch<3>;

}  // namespace fiberchain::dem
