#include "compare/static/tip.hpp"

#include <chrono>
#include <cmath>

#include "dem/equilibrium/newton.hpp"

namespace fiberchain::compare {
namespace {

using reference::TipState;
using Clock = std::chrono::steady_clock;

double turned(const dem::Pose<double, 2>& pose) { return pose.orientation; }
double turned(const dem::Pose<double, 3>& pose) {
  const auto axis = dem::axis(pose);
  return std::atan2(axis[1], axis[0]);
}

template <int Dim>
TipState tip_state(const dem::Poses<Dim>& poses, double length) {
  const dem::Pose<double, Dim>& tip = poses.back();
  return {tip.position[1] / length, 1 - tip.position[0] / length, turned(tip)};
}

template <int Dim>
dem::RelaxCase<Dim> cantilever(const dem::Fiber& fiber, double load) {
  const int tip = fiber.aspect_ratio;
  dem::Load<Dim> end{tip, {}, {}};
  end.force[1] = dem::load_force(fiber, load);
  return {dem::straight_chain<Dim>(fiber), {{{0}, {end}}}};
}

template <int Dim>
ChainTip solve_tip(const dem::Fiber& fiber, double load) {
  const dem::RelaxCase<Dim> job = cantilever<Dim>(fiber, load);
  const auto begin = Clock::now();
  const auto found = dem::solve_equilibrium(job.chain, job.loading[0]);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  ChainTip result;
  result.tip = result.solved = tip_state<Dim>(found.poses, dem::fiber_length(fiber));
  result.residual = found.residual.moment;
  result.stability = found.stability;
  result.iterations = found.statistics.newton_iterations;
  result.run_time = seconds;
  return result;
}

/// Where the march still has to go: K^-1 times the forces it left, at its last state.
template <int Dim>
TipState leftover(const dem::RelaxCase<Dim>& job, const dem::RelaxResult<Dim>& march, double length) {
  dem::ChainVector<Dim> motion = march.net;
  auto K = dem::stiffness(job.chain, march.poses, job.loading[0]);
  dem::solve_in_place(K, motion);
  const auto& tip = motion.back();
  // minus the motion to rest; the angle is the rotation about z
  return {-tip[1] / length, tip[0] / length, -tip[Dim == 2 ? 2 : 5]};
}

template <int Dim>
std::vector<dem::RelaxResult<Dim>> march_all(const std::vector<dem::RelaxCase<Dim>>& jobs,
                                             dem::RelaxOptions options, double step_factor) {
  if (step_factor != 1) {
    const dem::Fiber& fiber = jobs[0].chain.fiber;
    options.step_ratio = step_factor * dem::chosen_step(fiber, options) / dem::bond_time_step(fiber);
  }
  return dem::relax_to_equilibrium(jobs, options);
}

/// Marches a block of cases that differ in the load only.
template <int Dim>
std::vector<ChainTip> march_tips(const dem::Fiber& fiber, const std::vector<double>& loads,
                                 const dem::RelaxOptions& options) {
  std::vector<dem::RelaxCase<Dim>> jobs;
  for (const double load : loads) jobs.push_back(cantilever<Dim>(fiber, load));
  const double length = dem::fiber_length(fiber);
  const auto begin = Clock::now();
  const auto marched = march_all(jobs, options, 1.0);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  const bool incremental = options.form == dem::BondForm::incremental;
  const auto halved = incremental ? march_all(jobs, options, 0.5) : std::vector<dem::RelaxResult<Dim>>{};
  std::vector<ChainTip> tips;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    ChainTip tip = solve_tip<Dim>(fiber, loads[i]);
    tip.tip = tip_state<Dim>(marched[i].poses, length);
    tip.leftover = leftover(jobs[i], marched[i], length);
    const TipState at_rest = tip.tip - tip.leftover;
    if (incremental) {
      // second order in the step: u(dt) - u(0) = 4/3 (u(dt) - u(dt/2))
      const TipState finer = tip_state<Dim>(halved[i].poses, length) - leftover(jobs[i], halved[i], length);
      tip.time_step = 4.0 / 3.0 * (at_rest - finer);
    }
    tip.history = at_rest - tip.time_step - tip.solved;
    tip.residual = marched[i].residual.moment;
    tip.stability = dem::stability_of(jobs[i].chain, marched[i].poses, jobs[i].loading[0]);
    tip.steps = marched[i].steps;
    tip.run_time = seconds / static_cast<double>(jobs.size());
    tips.push_back(tip);
  }
  return tips;
}

}  // namespace

ChainTip solve_tip(int dimension, const dem::Fiber& fiber, double load) {
  return dimension == 2 ? solve_tip<2>(fiber, load) : solve_tip<3>(fiber, load);
}

std::vector<ChainTip> march_tips(int dimension, const dem::Fiber& fiber, const std::vector<double>& loads,
                                 const dem::RelaxOptions& options) {
  return dimension == 2 ? march_tips<2>(fiber, loads, options) : march_tips<3>(fiber, loads, options);
}

double small_load_departure(const dem::Fiber& fiber) {
  const double force = dem::load_force(fiber, 1.0), L = dem::fiber_length(fiber);
  const dem::RelaxCase<2> job = cantilever<2>(fiber, 1.0);
  const auto motion = dem::linear_response(job.chain, job.chain.poses, job.loading[0]);
  const double beam = force * L * L * L / (3 * dem::bending_stiffness(fiber));
  return motion.back()[1] / beam - 1;
}

}  // namespace fiberchain::compare
