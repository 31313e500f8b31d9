#include "dem/flow/follow_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dem/errors.hpp"
#include "dem/motion/lanes/chain_lane.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
void check_built(const FlowCase<Dim>& flow, const FlowOptions& options) {
  const Fiber& fiber = flow.chain.fiber;
  check(fiber);
  if (fiber.rolling_friction > 0) {
    throw InvalidInput(fmt::format("rolling_friction = {} is not allowed: it is not built for fibers in a fluid",
                                   fiber.rolling_friction));
  }
  if (options.form == BondForm::incremental && !flow.chain.natural.empty()) {
    throw InvalidInput("form = incremental is not allowed: bonds curved at rest in a fluid have the total form only");
  }
  if (flow.start.size() != flow.chain.poses.size()) {
    throw InvalidInput(fmt::format("start = {} poses is not allowed: the chain has {} spheres", flow.start.size(),
                                   flow.chain.poses.size()));
  }
}

template <int Dim>
Clamps clamps_of(const FlowCase<Dim>& flow) {
  const int last = flow.chain.fiber.aspect_ratio;
  Clamps clamps{false, false};
  for (const int sphere : flow.boundary.clamped) {
    if (sphere != 0 && sphere != last) {
      throw InvalidInput(fmt::format("clamped = {} is not allowed: the leapfrog clamps the end spheres 0 and {}", sphere,
                                     last));
    }
    (sphere == 0 ? clamps.first : clamps.last) = true;
  }
  return clamps;
}

double largest_step(const Fiber& fiber, double stable, const FlowOptions& options) {
  if (!options.step_ratio) return 0.8 * stable;
  const double ratio = *options.step_ratio, t_b = bond_time_step(fiber);
  if (!(ratio > 0) || !std::isfinite(ratio)) {
    throw InvalidInput(fmt::format("step_ratio = {} is not allowed: it must be finite and greater than 0", ratio));
  }
  if (ratio * t_b >= stable && !options.allow_unstable) {
    throw InvalidInput(fmt::format("step_ratio = {} is not allowed: the largest stable step of this chain in its fluid is "
                                   "{:.6g} t_b", ratio, stable / t_b));
  }
  return ratio * t_b;
}

template <int Dim>
Physics physics_of(const FlowCase<Dim>& flow, BondForm form) {
  return {.dimension = Dim, .form = form, .damped = damped(flow.chain.fiber), .drag = false,
          .curved = !flow.chain.natural.empty(), .fluid = true};
}

/// With the velocities of the undisturbed flow.
template <int Dim>
ChainState<Dim> state_at_start(const FlowCase<Dim>& flow) {
  ChainState<Dim> state = at_rest<Dim>(flow.start);
  const Gradient A = gradient_at(flow.fluid.flow, 0);
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    state.velocity[i] = velocity_at<Dim>(A, state.poses[i].position);
    state.spin[i] = spin_of<Dim>(A);
  }
  return state;
}

/// Steps between two looks at the whole chain: long enough that looking costs little.
constexpr int steps_between_looks = 256;

/// One fiber on its way.
template <int Dim>
class FlowMarch {
 public:
  FlowMarch(const FlowCase<Dim>& flow, double first_time, const FlowOptions& options)
      : flow_(flow),
        stable_(stable_time_step(flow.chain.fiber, flow.fluid)),
        largest_(largest_step(flow.chain.fiber, stable_, options)),
        step_(step_to(first_time)),
        block_({flow.chain}, clamps_of(flow), {step_}, {0.0}, physics_of(flow, options.form), options.instruction_set) {
    block_.set_fluid(0, flow.fluid);
    block_.set_loads(0, flow.boundary);
    put_state(block_, 0, flow.chain, state_at_start(flow));
    block_.synchronize();
  }

  /// Whole steps to a time; false if the chain blew up on the way.
  bool go_to(double time) {
    const double interval = time - time_;
    if (interval > 0) {
      take_step(step_to(time));
      const double steps = std::round(interval / step_);
      for (double done = 0; done < steps; done += steps_between_looks) {
        if (!stretch(static_cast<int>(std::min<double>(steps - done, steps_between_looks)))) return false;
      }
      time_ = time;
    }
    record.reached = time_;
    return true;
  }

  ChainState<Dim> state() const { return state_now(block_, 0, flow_.chain.fiber.aspect_ratio + 1); }

  FlowRecord record{};

 private:
  /// The largest step allowed that leads to a time in whole steps.
  double step_to(double time) const {
    const double interval = time - time_;
    return interval > 0 ? interval / std::max(std::ceil(interval / largest_ * (1 - 1e-12)), 1.0) : largest_;
  }

  /// Equal intervals differ by the rounding of their ends; that is not worth another step.
  void take_step(double step) {
    if (std::abs(step - step_) > 1e-12 * step_) {
      block_.set_step(0, step);
      step_ = step;
    }
    record.time_step = std::max(record.time_step, step_);
  }

  bool stretch(int steps) {
    const std::vector<double> saved = block_.saved();
    block_.march(steps);
    const bool whole = broken_sphere(block_, 0, flow_.chain.fiber) < 0;
    if (!whole) {
      block_.restore(saved);
      find_break(steps);
    } else {
      count(steps);
    }
    return whole;
  }

  void count(int steps) {
    record.work.steps += steps;
    record.work.bond_evaluations += static_cast<double>(steps) * flow_.chain.fiber.aspect_ratio;
    time_ += steps * step_;
  }

  /// Goes over a stretch that broke the chain again, step by step, from where all was well.
  void find_break(int steps) {
    for (int n = 1; n <= steps; ++n) {
      record.reached = time_;
      block_.march(1);
      count(1);
      const int sphere = broken_sphere(block_, 0, flow_.chain.fiber);
      if (sphere >= 0) {
        record.failure = failure_text(sphere);
        return;
      }
    }
  }

  std::string failure_text(int sphere) const {
    const std::string cause = step_ >= stable_
                                  ? fmt::format("the step is beyond the stable one, {:.6g} s", stable_)
                                  : std::string("a flow or load far beyond the bonds' stiffness, or a step too long for it");
    return fmt::format("the run blew up: sphere {} at step {:.0f} (dt = {:.6g} s, t = {:.6g} s); likely cause: {}", sphere,
                       record.work.steps, step_, time_, cause);
  }

  const FlowCase<Dim>& flow_;
  double time_ = 0;
  double stable_, largest_, step_;
  MarchingBlock<Dim> block_;
};

}  // namespace

template <int Dim>
FlowRecord follow_by_leapfrog(const FlowCase<Dim>& flow, const std::vector<double>& times, const FlowOptions& options,
                              const FlowSample<Dim>& sample) {
  check_built(flow, options);
  check<Dim>(flow.fluid);
  const auto first = std::ranges::find_if(times, [](double time) { return time > 0; });
  FlowMarch<Dim> march(flow, first == times.end() ? 0 : *first, options);
  for (const double time : times) {
    if (!march.go_to(time)) break;
    sample(time, time > 0 ? march.state() : state_at_start(flow));
  }
  return march.record;
}

template FlowRecord follow_by_leapfrog<2>(const FlowCase<2>&, const std::vector<double>&, const FlowOptions&,
                                          const FlowSample<2>&);
template FlowRecord follow_by_leapfrog<3>(const FlowCase<3>&, const std::vector<double>&, const FlowOptions&,
                                          const FlowSample<3>&);

}  // namespace fiberchain::dem
