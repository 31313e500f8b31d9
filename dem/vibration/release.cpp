#include "dem/vibration/release.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <tuple>

#include "dem/errors.hpp"
#include "dem/motion/lanes/block.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
void check(const Release<Dim>& release, const ReleaseOptions& options) {
  check(release.chain.fiber);
  const std::size_t spheres = release.chain.poses.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == spheres; };
  if (release.start.size() != spheres || !fits(release.velocity.size()) || !fits(release.spin.size())) {
    throw InvalidInput("a release needs a pose, and a velocity and spin or none, for every sphere of its chain");
  }
  if (!(release.period > 0) || !std::isfinite(release.period)) {
    throw InvalidInput(fmt::format("period = {} is not allowed: it must be finite and greater than 0", release.period));
  }
  if (!(release.periods > 0) || !std::isfinite(release.periods)) {
    throw InvalidInput(fmt::format("periods = {} is not allowed: it must be finite and greater than 0", release.periods));
  }
  if (options.samples_per_period < 4) {
    throw InvalidInput(fmt::format("samples_per_period = {} is not allowed: it must be 4 or more",
                                   options.samples_per_period));
  }
}

/// Steps between two samples.
template <int Dim>
int steps_per_sample(const Release<Dim>& release, const ReleaseOptions& options) {
  const Fiber& fiber = release.chain.fiber;
  const double t_b = bond_time_step(fiber), limit = stable_time_step(fiber);
  double step = std::min(0.25 * t_b, 0.8 * limit);
  if (options.step_ratio) {
    step = *options.step_ratio * t_b;
    if (!(step > 0)) {
      throw InvalidInput(fmt::format("step_ratio = {} is not allowed: it must be greater than 0", *options.step_ratio));
    }
    if (step >= limit && !options.allow_unstable) {
      throw InvalidInput(fmt::format("step_ratio = {} is not allowed: the largest stable step of this chain is {:.4f} "
                                     "t_b", *options.step_ratio, limit / t_b));
    }
  }
  const double steps = std::ceil(release.period / (options.samples_per_period * step) * (1 - 1e-12));
  return static_cast<int>(std::max(steps, 1.0));
}

/// Puts a release into its lane: poses, velocities and, for the incremental form, the strain they stand for.
template <int Dim>
void place(MarchingBlock<Dim>& block, int lane, const Release<Dim>& release) {
  for (std::size_t i = 0; i < release.start.size(); ++i) {
    MovingSphere<double, Dim> sphere = block.sphere(lane, static_cast<int>(i));
    sphere.pose = release.start[i];
    if (!release.velocity.empty()) sphere.velocity = release.velocity[i];
    if (!release.spin.empty()) sphere.spin = release.spin[i];
    block.set_sphere(lane, static_cast<int>(i), sphere);
  }
  const BondParameters<double> bond = bond_parameters(release.chain.fiber);
  for (int i = 0; i < release.chain.fiber.aspect_ratio; ++i) {
    const auto k = bond_kinematics(release.chain, release.start, i);
    const auto loads = bond_loads(k, bond_stress(bond, k.separation, k.rotation));
    block.set_history(lane, i, history_of(bond, release.start[i + 1].position - release.start[i].position, loads));
  }
}

/// Energy at the moment of the poses; v(-1/2) v(+1/2) makes the kinetic part exact for a linear chain.
template <int Dim>
double energy(const MarchingBlock<Dim>& block, int lane, const Release<Dim>& release, double dt, BondForm form) {
  const Fiber& fiber = release.chain.fiber;
  const double m = sphere_mass(fiber), J = sphere_inertia(fiber);
  const BondParameters<double> bond = bond_parameters(fiber);
  double sum = form == BondForm::total ? elastic_energy(release.chain, block.poses(lane)) : 0.0;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const MovingSphere<double, Dim> s = block.sphere(lane, i);
    const bool clamped = i == 0;
    if (!clamped) {
      sum += 0.5 * m * dot(s.velocity, s.velocity + (dt / m) * s.force);
      sum += 0.5 * J * dot(s.spin, s.spin + (dt / J) * s.moment);
    }
    if (form == BondForm::incremental && i < fiber.aspect_ratio) {
      sum += stored_energy(bond, block.history(lane, i), unit(block.sphere(lane, i + 1).pose.position - s.pose.position));
    }
  }
  return sum;
}

template <int Dim>
TipSample<Dim> sample(const MarchingBlock<Dim>& block, int lane, const Release<Dim>& release, double dt, double steps,
                      const ReleaseOptions& options) {
  const int tip = release.chain.fiber.aspect_ratio;
  const MovingSphere<double, Dim> s = block.sphere(lane, tip);
  const Vec<double, Dim> velocity = s.velocity + (0.5 * dt / sphere_mass(release.chain.fiber)) * s.force;
  if (!std::isfinite(dot(s.pose.position, s.pose.position) + dot(velocity, velocity))) {
    throw Diverged(fmt::format("the ring-down diverged: fiber {}, sphere {} is not finite at step {:.0f} (dt = {:.6g} s, "
                               "t = {:.6g} s); likely cause: the state it was let go from", lane, tip, steps, dt,
                               steps * dt));
  }
  return {steps * dt, s.pose.position, velocity,
          options.energy ? energy(block, lane, release, dt, options.form) : 0.0};
}

/// Chains with the same number of steps between samples, and of samples, side by side.
template <int Dim>
void march_block(const std::vector<Release<Dim>>& all, const std::vector<std::size_t>& members, int stride, int samples,
                 const ReleaseOptions& options, std::vector<ReleaseRecord<Dim>>& records) {
  std::vector<Chain<Dim>> chains;
  std::vector<double> steps;
  bool any_damped = false;
  for (const std::size_t i : members) {
    chains.push_back(all[i].chain);
    steps.push_back(release_step(all[i], options));
    any_damped = any_damped || damped(all[i].chain.fiber);
  }
  const Physics physics{Dim, options.form, any_damped, false, options.form == BondForm::total && !chains[0].natural.empty()};
  MarchingBlock<Dim> block(chains, {true, false}, steps, std::vector<double>(chains.size(), 0.0), physics,
                           options.instruction_set);
  for (std::size_t lane = 0; lane < members.size(); ++lane) place(block, static_cast<int>(lane), all[members[lane]]);
  block.synchronize();
  const auto record = [&](double done) {
    for (std::size_t lane = 0; lane < members.size(); ++lane) {
      records[members[lane]].samples.push_back(
          sample(block, static_cast<int>(lane), all[members[lane]], steps[lane], done, options));
    }
  };
  record(0);
  for (int n = 1; n <= samples; ++n) {
    block.march(stride);
    record(static_cast<double>(n) * stride);
  }
  for (std::size_t lane = 0; lane < members.size(); ++lane) {
    records[members[lane]].time_step = steps[lane];
    const double marched = static_cast<double>(samples) * stride;
    records[members[lane]].steps = marched;
    records[members[lane]].integrator = Integrator::leapfrog;
    records[members[lane]].work = {.steps = marched, .bond_evaluations = marched * chains[lane].fiber.aspect_ratio};
  }
}

}  // namespace

template <int Dim>
double release_step(const Release<Dim>& release, const ReleaseOptions& options) {
  return release.period / (static_cast<double>(options.samples_per_period) * steps_per_sample(release, options));
}

template <int Dim>
std::vector<ReleaseRecord<Dim>> ring_down(const std::vector<Release<Dim>>& releases, const ReleaseOptions& options) {
  // what can share a block: equal length, damped or not, straight or not, and the same numbers of steps
  std::map<std::tuple<int, bool, bool, int, int>, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < releases.size(); ++i) {
    const Release<Dim>& r = releases[i];
    check(r, options);
    if (options.integrator != Integrator::leapfrog) throw InvalidInput("this integrator is not built");
    const int samples = static_cast<int>(std::ceil(r.periods * options.samples_per_period));
    groups[{r.chain.fiber.aspect_ratio, damped(r.chain.fiber), r.chain.natural.empty(), steps_per_sample(r, options),
            samples}].push_back(i);
  }
  const std::size_t width = lane_kernel(built_physics[0], options.instruction_set).width;
  std::vector<ReleaseRecord<Dim>> records(releases.size());
  for (const auto& [kind, members] : groups) {
    for (std::size_t first = 0; first < members.size(); first += width) {
      const std::size_t end = std::min(first + width, members.size());
      march_block(releases, {members.begin() + first, members.begin() + end}, std::get<3>(kind), std::get<4>(kind),
                  options, records);
    }
  }
  return records;
}

template double release_step<2>(const Release<2>&, const ReleaseOptions&);
template double release_step<3>(const Release<3>&, const ReleaseOptions&);
template std::vector<ReleaseRecord<2>> ring_down<2>(const std::vector<Release<2>>&, const ReleaseOptions&);
template std::vector<ReleaseRecord<3>> ring_down<3>(const std::vector<Release<3>>&, const ReleaseOptions&);

}  // namespace fiberchain::dem
