#include "dem/flow/leapfrog_in_flow.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "dem/flow/flow_batch.hpp"
#include "dem/flow/stretch_limit.hpp"
#include "dem/model/errors.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/motion/stiff_limits.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
void check_built(const FlowCase<Dim>& flow, const FlowOptions& options) {
  check(flow);
  if (options.form == BondForm::incremental && !flow.chain.natural.empty()) {
    throw InvalidInput(
        "form = incremental is not allowed: bonds curved at rest in a fluid have the total form only");
  }
}

template <int Dim>
Clamps clamps_of(const FlowCase<Dim>& flow) {
  const int last = flow.chain.fiber.aspect_ratio;
  Clamps clamps{false, false};
  for (const int sphere : flow.boundary.clamped) {
    if (sphere != 0 && sphere != last) {
      throw InvalidInput(fmt::format(
          "clamped = {} is not allowed: the leapfrog clamps the end spheres 0 and {}", sphere, last));
    }
    (sphere == 0 ? clamps.first : clamps.last) = true;
  }
  return clamps;
}

/// Largest step with the springs solved for [s]: bonds turn at most as fast as the flow's gradient, their
/// tension is at most that which the flow's stretching draws them out with, and bending is followed.
double largest_stiff_step(const Fiber& fiber, const Fluid& fluid, double turn, double period_part) {
  const Gradient A = gradient_at(fluid.flow, 0);
  double squares = 0;
  for (int n = 0; n < 9; ++n) squares += A[n / 3][n % 3] * A[n / 3][n % 3];
  const double bonds = fiber.aspect_ratio, rate = std::sqrt(squares),
               tension = stokes_drag(fluid, fiber).translation * largest_stretching(A) * bond_length(fiber) *
                         bonds * bonds / 8;
  double step = std::min(period_part * free_bending_period(fiber), step_for_tension(fiber, tension));
  return rate > 0 ? std::min(step, turn / rate) : step;
}

double stable_step(const Fiber& fiber, const Fluid& fluid, const FlowOptions& options) {
  if (options.method != FlowMethod::leapfrog_stiff) return stable_time_step(fiber, fluid);
  return largest_stiff_step(fiber, fluid, largest_turn, 0.1);
}

double largest_step(const Fiber& fiber, const Fluid& fluid, double stable, const FlowOptions& options) {
  if (!options.step_ratio) {
    return options.method == FlowMethod::leapfrog_stiff
               ? largest_stiff_step(fiber, fluid, safe_turn, followed_period_part)
               : 0.8 * stable;
  }
  const double ratio = *options.step_ratio, t_b = bond_time_step(fiber);
  if (!(ratio > 0) || !std::isfinite(ratio)) {
    throw InvalidKey(
        "step_ratio",
        fmt::format("step_ratio = {} is not allowed: it must be finite and greater than 0", ratio));
  }
  if (ratio * t_b >= stable && !options.allow_unstable) {
    throw InvalidKey(
        "step_ratio",
        fmt::format("step_ratio = {} is not allowed: the largest stable step of this chain in its fluid is "
                    "{:.6g} t_b",
                    ratio, stable / t_b));
  }
  return ratio * t_b;
}

/// What can share a block: equal length, damped or not, straight or not, clamped alike, equal numbers of
/// steps.
template <int Dim>
auto kind_of(const FlowJob<Dim>& job, const FlowPlan& plan) {
  return std::tuple{job.flow.chain.fiber.aspect_ratio,
                    damped(job.flow.chain.fiber),
                    job.flow.chain.natural.empty(),
                    plan.clamps.first,
                    plan.clamps.last,
                    plan.counts};
}

}  // namespace

template <int Dim>
FlowPlan plan_of(const FlowCase<Dim>& flow, const std::vector<double>& times, const FlowOptions& options) {
  check_built(flow, options);
  FlowPlan plan{stable_step(flow.chain.fiber, flow.fluid, options), {}, {}, clamps_of(flow)};
  const double largest = largest_step(flow.chain.fiber, flow.fluid, plan.stable, options);
  double before = 0;
  for (const double time : times) {
    const double interval = time - before;
    if (!(interval >= 0)) {
      throw InvalidInput(fmt::format("times: {} after {} is not allowed: they must not fall", time, before));
    }
    plan.counts.push_back(interval > 0 ? std::max(std::ceil(interval / largest * (1 - 1e-12)), 1.0) : 0.0);
    plan.lengths.push_back(interval / std::max(plan.counts.back(), 1.0));
    before = time;
  }
  return plan;
}

template <int Dim>
FlowRecord leapfrog_in_flow(const FlowCase<Dim>& flow, const std::vector<double>& times,
                            const FlowOptions& options, const FlowSample<Dim>& sample) {
  FlowBatch<Dim> march({{&flow, &times, plan_of(flow, times, options)}}, options);
  return march.run([&](std::size_t, double time, const ChainState<Dim>& state) { sample(time, state); })[0];
}

template <int Dim>
std::vector<FlowRecord> leapfrog_many_in_flow(const std::vector<FlowJob<Dim>>& jobs,
                                              const FlowOptions& options, const FlowJobSample<Dim>& sample) {
  std::vector<FlowPlan> plans;
  for (const FlowJob<Dim>& job : jobs) plans.push_back(plan_of(job.flow, job.times, options));
  std::map<decltype(kind_of(jobs[0], plans[0])), std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < jobs.size(); ++i) groups[kind_of(jobs[i], plans[i])].push_back(i);
  const std::size_t width = chain_kernel(built_physics[0], options.instruction_set).width;
  std::vector<FlowRecord> records(jobs.size());
  for (const auto& [kind, numbers] : groups) {
    for (std::size_t first = 0; first < numbers.size(); first += width) {
      const std::size_t end = std::min(first + width, numbers.size());
      std::vector<typename FlowBatch<Dim>::Member> members;
      for (std::size_t i = first; i < end; ++i) {
        members.push_back({&jobs[numbers[i]].flow, &jobs[numbers[i]].times, plans[numbers[i]]});
      }
      FlowBatch<Dim> march(std::move(members), options);
      const auto done = march.run([&](std::size_t lane, double time, const ChainState<Dim>& state) {
        sample(numbers[first + lane], time, state);
      });
      for (std::size_t i = first; i < end; ++i) records[numbers[i]] = done[i - first];
    }
  }
  return records;
}

#define FIBERCHAIN_INSTANTIATE(Dim)                                                                     \
  template FlowPlan plan_of<Dim>(const FlowCase<Dim>&, const std::vector<double>&, const FlowOptions&); \
  template FlowRecord leapfrog_in_flow<Dim>(const FlowCase<Dim>&, const std::vector<double>&,           \
                                            const FlowOptions&, const FlowSample<Dim>&);                \
  template std::vector<FlowRecord> leapfrog_many_in_flow<Dim>(                                          \
      const std::vector<FlowJob<Dim>>&, const FlowOptions&, const FlowJobSample<Dim>&);
FIBERCHAIN_INSTANTIATE(2)
FIBERCHAIN_INSTANTIATE(3)
#undef FIBERCHAIN_INSTANTIATE

}  // namespace fiberchain::dem
