#include "dem/flow/integrate_in_flow.hpp"

#include <fmt/format.h>
#include <cmath>

#include "dem/chain/flow_at_spheres.hpp"
#include "dem/flow/inertialess.hpp"
#include "dem/flow/leapfrog_in_flow.hpp"
#include "dem/flow/stretch_limit.hpp"
#include "dem/model/errors.hpp"
#include "dem/motion/cvode.hpp"

namespace fiberchain::dem {

template <int Dim>
void check(const FlowCase<Dim>& flow) {
  check(flow.chain.fiber);
  check<Dim>(flow.fluid);
  if (flow.start.size() != flow.chain.poses.size()) {
    throw InvalidInput(fmt::format("start = {} poses is not allowed: the chain has {} spheres",
                                   flow.start.size(), flow.chain.poses.size()));
  }
  refuse_branches(flow.chain.fiber, "fibers in a fluid");
  refuse_failure(flow.chain.fiber, "fibers in a fluid");
  if (flow.chain.fiber.rolling_friction > 0) {
    throw InvalidInput(
        fmt::format("rolling_friction = {} is not allowed: it is not built for fibers in a fluid",
                    flow.chain.fiber.rolling_friction));
  }
}

template <int Dim>
ChainState<Dim> carried_state(const FlowCase<Dim>& flow) {
  ChainState<Dim> state = at_rest<Dim>(flow.start);
  const Gradient A = gradient_at(flow.fluid.flow, 0);
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    state.velocity[i] = velocity_at<Dim>(A, state.poses[i].position);
    state.spin[i] = spin_of<Dim>(A);
  }
  for (const int sphere : flow.boundary.clamped) state.velocity[sphere] = {}, state.spin[sphere] = {};
  return state;
}

namespace {

template <int Dim>
void check_case(const FlowCase<Dim>& flow, const std::vector<double>& times, const FlowOptions& options) {
  check(flow);
  if (options.method != FlowMethod::inertialess && flow.fluid.hydrodynamics != Hydrodynamics::free_draining) {
    throw InvalidInput(fmt::format("hydrodynamics: {} is built for method: inertialess only",
                                   name(flow.fluid.hydrodynamics)));
  }
  if (!is_leapfrog(options.method) && options.form == BondForm::incremental) {
    throw InvalidInput("form: incremental is built for method: leapfrog and leapfrog-stiff only");
  }
  double before = 0;
  for (const double time : times) {
    if (!(time >= before) || !std::isfinite(time))
      throw InvalidInput("times must be finite and must not fall");
    before = time;
  }
}

template <int Dim>
CvodeMotion<Dim> motion_with_inertia(const FlowCase<Dim>& flow, double tolerance, double duration) {
  const double rate = largest_rate(flow.fluid.flow.gradient);
  const CvodeTolerance errors{tolerance, fiber_length(flow.chain.fiber), 1, rate > 0 ? 1 / rate : duration,
                              1000000};
  const auto velocity = [fluid = flow.fluid](double time, const Poses<Dim>& poses) {
    return undisturbed<Dim>(gradient_at(fluid.flow, time), poses);
  };
  return {flow.chain, flow.boundary, carried_state(flow), errors,
          Medium<Dim>{drag_of<Dim>(flow.fluid, flow.chain.fiber), velocity}};
}

template <int Dim, class Motion>
FlowRecord record_motion(const FlowCase<Dim>& flow, Motion motion, const std::vector<double>& times,
                         const FlowSample<Dim>& sample) {
  FlowRecord record{};
  try {
    for (const double time : times) {
      const ChainState<Dim> state = motion.at(time);
      record.failure = stretch_failure(flow.chain, state.poses, flow.fluid, time);
      if (!record.failure.empty()) break;
      sample(time, state);
      record.reached = time;
    }
  } catch (const Diverged& error) {
    record.failure = error.what();
  }
  record.work = motion.work();
  record.time_step = record.work.steps > 0 ? record.reached / record.work.steps : 0;
  return record;
}

}  // namespace

template <int Dim>
FlowRecord integrate_in_flow(const FlowCase<Dim>& flow, const std::vector<double>& times,
                             const FlowOptions& options, const FlowSample<Dim>& handed_out) {
  check_case(flow, times, options);
  const FlowSample<Dim> sample = [&](double time, const ChainState<Dim>& state) {
    stop_if_asked(options.asked_to_stop, "stopped in the flow");
    handed_out(time, state);
  };
  switch (options.method) {
    case FlowMethod::inertialess:
      return record_motion<Dim>(flow, InertialessMotion<Dim>(flow, options.tolerance), times, sample);
    case FlowMethod::cvode:
      return record_motion<Dim>(
          flow, motion_with_inertia(flow, options.tolerance, times.empty() ? 1 : times.back()), times,
          sample);
    default:
      return leapfrog_in_flow(flow, times, options, sample);
  }
}

template void check<2>(const FlowCase<2>&);
template void check<3>(const FlowCase<3>&);
template ChainState<2> carried_state<2>(const FlowCase<2>&);
template ChainState<3> carried_state<3>(const FlowCase<3>&);
template FlowRecord integrate_in_flow<2>(const FlowCase<2>&, const std::vector<double>&, const FlowOptions&,
                                         const FlowSample<2>&);
template FlowRecord integrate_in_flow<3>(const FlowCase<3>&, const std::vector<double>&, const FlowOptions&,
                                         const FlowSample<3>&);

}  // namespace fiberchain::dem
