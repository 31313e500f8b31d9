#include "dem/equilibrium/dynamic_relaxation.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "dem/model/errors.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/motion/kernels/chain_batch.hpp"
#include "dem/motion/physics_of.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::dem {
namespace {

constexpr const char* kStopped = "stopped on the way to rest";

void check_option(bool allowed, const char* key, double value, const char* allowed_text) {
  if (!allowed) throw InvalidInput(fmt::format("{} = {} is not allowed: {}", key, value, allowed_text));
}

void check(const RelaxOptions& o) {
  check_option(o.bond_damping >= 0 && std::isfinite(o.bond_damping), "bond_damping", o.bond_damping,
               "it must be finite and 0 or more");
  check_option(o.drag >= 0 && std::isfinite(o.drag), "drag", o.drag, "it must be finite and 0 or more");
  check_option(o.drag > 0 || o.bond_damping > 0, "drag", o.drag,
               "without bond damping it must be positive, or the chain never rests");
  if (o.step_ratio) check_option(*o.step_ratio > 0, "step_ratio", *o.step_ratio, "it must be greater than 0");
  check_option(o.ramp_periods >= 0 && std::isfinite(o.ramp_periods), "ramp_periods", o.ramp_periods,
               "it must be finite and 0 or more");
  check_option(o.residual > 0 && o.residual < 1, "residual", o.residual, "it must lie between 0 and 1");
  check_option(o.max_periods > 0, "max_periods", o.max_periods, "it must be greater than 0");
}

template <int Dim>
Clamps end_clamps(const RelaxCase<Dim>& job) {
  const int last = job.chain.fiber.aspect_ratio;
  Clamps clamps{false, false};
  if (job.loading.empty())
    throw InvalidInput("loading = none is not allowed: a march needs at least one set of loads");
  for (const Boundary<Dim>& boundary : job.loading) {
    for (const Load<Dim>& load : boundary.loads) {
      if (load.sphere != 0 && load.sphere != last) {
        throw InvalidInput(fmt::format(
            "load at sphere {} is not allowed: a march loads the end spheres 0 and {}", load.sphere, last));
      }
    }
  }
  for (const int sphere : job.loading[0].clamped) {
    if (sphere != 0 && sphere != last) {
      throw InvalidInput(
          fmt::format("clamped = {} is not allowed: a march clamps the end spheres 0 and {}", sphere, last));
    }
    (sphere == 0 ? clamps.first : clamps.last) = true;
  }
  if (!clamps.first && !clamps.last)
    throw InvalidInput("clamped = none is not allowed: an equilibrium needs a clamp");
  return clamps;
}

/// What one lane does: where it is on its loading path and when it came to rest.
template <int Dim>
struct Lane {
  const RelaxCase<Dim>* job;
  Chain<Dim> chain;  ///< with the settling damping
  double time_step;
  std::optional<RelaxResult<Dim>> result;
};

template <int Dim>
RelaxResult<Dim> measure(const ChainBatch<Dim>& block, int index, const Lane<Dim>& lane, double steps) {
  const int spheres = lane.chain.fiber.aspect_ratio + 1;
  const Boundary<Dim>& boundary = lane.job->loading.back();
  ChainVector<Dim> net = applied_loads(boundary, spheres);
  Poses<Dim> poses;
  double speed = 0;
  for (int i = 0; i < spheres; ++i) {
    const MovingSphere<double, Dim> sphere = block.sphere(index, i);
    if (!std::isfinite(dot(sphere.pose.position, sphere.pose.position) + dot(sphere.spin, sphere.spin))) {
      throw Diverged(
          fmt::format("the march diverged: fiber {}, sphere {} is not finite at step {:.0f} (dt = {:.6g} s); "
                      "likely causes: a step "
                      "too large for this load or a load far beyond the bonds' stiffness",
                      index, i, steps, lane.time_step));
    }
    poses.push_back(sphere.pose);
    speed = std::max(speed, norm(sphere.velocity));
    net[i].template head<Dim>() += tangent_detail::eigen(sphere.force);
    net[i].template tail<spin_size<Dim>>() += tangent_detail::eigen(sphere.moment);
  }
  for (const int clamp : lane.job->loading[0].clamped) net[clamp].setZero();
  const double length = fiber_length(lane.chain.fiber);
  const double scale = first_bending_frequency(lane.chain.fiber) * length;
  const Imbalance residual = imbalance(poses, net, boundary, length);
  return {std::move(poses), std::move(net), residual, speed / scale, lane.time_step, steps};
}

/// The fiber with the dashpots that settle it; its branches will have relaxed.
Fiber settling_fiber(Fiber fiber, const RelaxOptions& options) {
  fiber.bond_damping = options.bond_damping;
  fiber.dashpots = DashpotLaw::bond_damping;
  fiber.retardation_time = 0;
  fiber.branches = {};
  return fiber;
}

/// Force per momentum [1/s]: critical damping of the first bending mode is 2 omega_1.
double settling_drag(const Fiber& fiber, const RelaxOptions& options) {
  return 2 * options.drag * first_bending_frequency(fiber);
}

/// Marches the chains of one block through their loads to rest.
template <int Dim>
void march_block(std::vector<Lane<Dim>>& lanes, const RelaxOptions& options) {
  std::vector<Chain<Dim>> chains;
  std::vector<double> steps, drag;
  double steps_per_period = 0;
  for (Lane<Dim>& lane : lanes) {
    const double omega = first_bending_frequency(lane.chain.fiber);
    chains.push_back(lane.chain);
    drag.push_back(settling_drag(lane.chain.fiber, options));
    lane.time_step = chosen_step(lane.chain.fiber, options);
    steps.push_back(lane.time_step);
    steps_per_period = std::max(steps_per_period, 2 * std::numbers::pi / (omega * lane.time_step));
  }
  const Physics physics =
      physics_of<Dim>(chains, {.form = options.form, .settling_damping = options.drag > 0});
  ChainBatch<Dim> block(chains, end_clamps(*lanes[0].job), steps, drag, physics, options.instruction_set);
  const int check_every = std::max(static_cast<int>(steps_per_period / 20), 1);
  const double ramp_steps = options.ramp_periods * steps_per_period;
  double done = 0;
  for (std::size_t phase = 0; phase < lanes[0].job->loading.size(); ++phase) {
    block.restart_ramp();
    for (int i = 0; i < block.lanes(); ++i) {
      const auto& loading = lanes[i].job->loading;
      block.set_ramp(i, phase == 0 ? Boundary<Dim>{} : loading[phase - 1], loading[phase], ramp_steps);
    }
    for (double ramped = 0; ramped < ramp_steps; ramped += check_every) {
      stop_if_asked(options.asked_to_stop, kStopped);
      block.march(check_every);
      done += check_every;
    }
  }
  const double limit = done + options.max_periods * steps_per_period;
  std::size_t resting = 0;
  while (resting < lanes.size()) {
    stop_if_asked(options.asked_to_stop, kStopped);
    block.march(check_every);
    done += check_every;
    for (int i = 0; i < block.lanes(); ++i) {
      if (lanes[i].result) continue;
      RelaxResult<Dim> now = measure(block, i, lanes[i], done);
      if (now.residual.moment < options.residual && now.speed < options.residual) {
        lanes[i].result = std::move(now);
        ++resting;
      } else if (done > limit) {
        throw NoConvergence(
            fmt::format("fiber {} is not at rest after {:.0f} steps: moment out of balance {:.3g}, speed "
                        "{:.3g}, both should be below {:.3g}",
                        i, done, now.residual.moment, now.speed, options.residual));
      }
    }
  }
}

}  // namespace

double chosen_step(const Fiber& fiber, const RelaxOptions& options) {
  const Fiber settling = settling_fiber(fiber, options);
  const double limit = stable_time_step(settling, settling_drag(fiber, options));
  if (!options.step_ratio) return 0.8 * limit;
  const double step = *options.step_ratio * bond_time_step(fiber);
  if (step >= limit) {
    throw InvalidKey(
        "step_ratio",
        fmt::format("step_ratio = {} is not allowed: with bond damping {} the largest stable step of "
                    "this chain is {:.4f} t_b",
                    *options.step_ratio, options.bond_damping, limit / bond_time_step(fiber)));
  }
  return step;
}

double first_bending_frequency(const Fiber& fiber) {
  constexpr double beta_1 = 1.8751040687119611;
  const double L = fiber_length(fiber);
  return beta_1 * beta_1 * std::sqrt(bending_stiffness(fiber) * bond_length(fiber) / sphere_mass(fiber)) /
         (L * L);
}

template <int Dim>
std::vector<RelaxResult<Dim>> relax_to_equilibrium(const std::vector<RelaxCase<Dim>>& cases,
                                                   const RelaxOptions& options) {
  check(options);
  // cases that can share a block: same length, kind, clamps and number of load sets
  std::map<std::tuple<int, bool, bool, bool, std::size_t>, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Clamps clamps = end_clamps(cases[i]);
    groups[{cases[i].chain.fiber.aspect_ratio, cases[i].chain.natural.empty(), clamps.first, clamps.last,
            cases[i].loading.size()}]
        .push_back(i);
  }
  const std::size_t width = chain_kernel(built_physics[0], options.instruction_set).width;
  std::vector<RelaxResult<Dim>> results(cases.size());
  for (const auto& [kind, members] : groups) {
    for (std::size_t first = 0; first < members.size(); first += width) {
      std::vector<Lane<Dim>> lanes;
      const std::size_t end = std::min(first + width, members.size());
      for (std::size_t i = first; i < end; ++i) {
        Lane<Dim> lane{&cases[members[i]], cases[members[i]].chain, 0, {}};
        lane.chain.fiber = settling_fiber(lane.chain.fiber, options);
        lanes.push_back(std::move(lane));
      }
      march_block(lanes, options);
      for (std::size_t i = first; i < end; ++i) results[members[i]] = std::move(*lanes[i - first].result);
    }
  }
  return results;
}

template std::vector<RelaxResult<2>> relax_to_equilibrium<2>(const std::vector<RelaxCase<2>>&,
                                                             const RelaxOptions&);
template std::vector<RelaxResult<3>> relax_to_equilibrium<3>(const std::vector<RelaxCase<3>>&,
                                                             const RelaxOptions&);

}  // namespace fiberchain::dem
