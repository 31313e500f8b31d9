#include "dem/vibration/release_lanes.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "dem/motion/kernels/chain_lane.hpp"
#include "dem/motion/physics_of.hpp"
#include "dem/motion/stiff_limits.hpp"
#include "dem/motion/time_step.hpp"

namespace fiberchain::dem {
namespace {

/// Puts a release into its lane.
template <int Dim>
void place(ChainBatch<Dim>& block, int lane, const Release<Dim>& release) {
  ChainState<Dim> state = at_rest<Dim>(release.start);
  if (!release.velocity.empty()) state.velocity = release.velocity;
  if (!release.spin.empty()) state.spin = release.spin;
  put_state(block, lane, release.chain, state);
}

/// Energy at the moment of the poses, with the spheres' velocities then; without them v(-1/2) v(+1/2), which
/// makes the kinetic part of an explicit step exact for a linear chain.
template <int Dim>
double energy(const ChainBatch<Dim>& block, int lane, const Release<Dim>& release, double dt, BondForm form,
              const std::vector<MovingSphere<double, Dim>>& now) {
  const Fiber& fiber = release.chain.fiber;
  const BondParameters<double> bond = bond_parameters(fiber);
  double sum = form == BondForm::total ? elastic_energy(release.chain, block.poses(lane)) : 0.0;
  for (int i = 0; i <= fiber.aspect_ratio; ++i) {
    const MovingSphere<double, Dim> s = block.sphere(lane, i);
    const bool clamped = i == 0;
    if (!clamped) {
      const double share = mass_share(fiber, i), m = share * sphere_mass(fiber),
                   J = share * sphere_inertia(fiber);
      if (now.empty()) {
        sum += 0.5 * m * dot(s.velocity, s.velocity + (dt / m) * s.force);
        sum += 0.5 * J * dot(s.spin, s.spin + (dt / J) * s.moment);
      } else {
        sum += 0.5 * (m * dot(now[i].velocity, now[i].velocity) + J * dot(now[i].spin, now[i].spin));
      }
    }
    if (form == BondForm::incremental && i < fiber.aspect_ratio) {
      sum += stored_energy(bond, block.history(lane, i),
                           unit(block.sphere(lane, i + 1).pose.position - s.pose.position));
    }
  }
  return sum + branch_energy(block, lane, release.chain, form);
}

template <int Dim>
TipSample<Dim> sample(const ChainBatch<Dim>& block, int lane, const Release<Dim>& release, double dt,
                      double steps, const ReleaseOptions& options) {
  const Fiber& fiber = release.chain.fiber;
  const MovingSphere<double, Dim> s = block.sphere(lane, fiber.aspect_ratio);
  std::vector<MovingSphere<double, Dim>> now;
  Vec<double, Dim> velocity;
  if (options.integrator == Integrator::leapfrog_stiff) {
    now = block.spheres_now(lane);
    velocity = now.back().velocity;
  } else {
    const double tip_mass = end_mass_share(fiber) * sphere_mass(fiber);
    velocity = s.velocity + (0.5 * dt / tip_mass) * s.force;
  }
  return {steps * dt, s.pose.position, velocity,
          options.energy ? energy(block, lane, release, dt, options.form, now) : 0.0};
}

std::string failure_text(std::size_t fiber, int sphere, double step, double dt, double limit) {
  const std::string cause =
      dt >= limit ? fmt::format("the step is beyond the stable one, {:.6g} s", limit)
                  : std::string("the state it was let go from, or a step too long for its speed");
  return fmt::format(
      "the run blew up: fiber {}, sphere {} at step {:.0f} (dt = {:.6g} s, t = {:.6g} s); likely cause: {}",
      fiber, sphere, step, dt, step * dt, cause);
}

std::string stiff_failure_text(std::size_t fiber, int bond, double step, double dt, double turn, double drawn,
                               double strain) {
  return fmt::format(
      "the run cannot be trusted: fiber {}, bond {} at step {:.0f} (dt = {:.6g} s, t = {:.6g} s) {}; likely "
      "cause: a step too long for its speed",
      fiber, bond, step, dt, step * dt,
      turn > largest_turn
          ? fmt::format("turned by {:.3g} rad in a step, allowed {:g}", turn, largest_turn)
          : fmt::format("is stretched by {:.3g}, the tension of {:.3g} is what such steps bear", drawn,
                        strain));
}

/// One block of chains and what is recorded of them.
template <int Dim>
struct March {
  const std::vector<Release<Dim>>& all;
  const std::vector<std::size_t>& members;
  const ReleaseOptions& options;
  std::vector<ReleaseRecord<Dim>>& records;
  std::vector<double> steps;
  ChainBatch<Dim> block;

  const Fiber& fiber(std::size_t lane) const { return all[members[lane]].chain.fiber; }

  bool all_broken() const {
    return std::ranges::all_of(members, [&](std::size_t i) { return !records[i].failure.empty(); });
  }

  void record(double done) {
    for (std::size_t lane = 0; lane < members.size(); ++lane) {
      ReleaseRecord<Dim>& r = records[members[lane]];
      if (!r.failure.empty()) continue;
      r.samples.push_back(
          sample(block, static_cast<int>(lane), all[members[lane]], steps[lane], done, options));
    }
  }

  /// Goes over a stretch that broke a lane again, step by step, from where all was well.
  void find_break(std::size_t lane, double from, int stretch) {
    ReleaseRecord<Dim>& r = records[members[lane]];
    const int spheres = fiber(lane).aspect_ratio + 1;
    for (int n = 1; n <= stretch; ++n) {
      r.last = lagged_state(block, static_cast<int>(lane), spheres);
      block.march(1);
      const int sphere = broken_sphere(block, static_cast<int>(lane), fiber(lane));
      if (sphere < 0) continue;
      const double step = from + n;
      r.steps = step;
      r.failure = failure_text(members[lane], sphere, step, steps[lane],
                               stable_release_step(fiber(lane), options.integrator));
      std::erase_if(r.samples, [&](const TipSample<Dim>& s) { return !(s.time < step * steps[lane]); });
      return;
    }
  }

  /// Stops a lane whose bonds turn in a step, or are drawn out, beyond what springs that are solved for bear.
  void check_stiff(std::size_t lane, double done) {
    ReleaseRecord<Dim>& r = records[members[lane]];
    const Fiber& fiber = this->fiber(lane);
    const double l = bond_length(fiber),
                 strain = largest_tension(fiber, steps[lane], stiff_beta, {true, false}) /
                          (bond_stiffness(fiber).stretch * l);
    for (int i = 0; i < fiber.aspect_ratio; ++i) {
      const auto a = block.sphere(static_cast<int>(lane), i), b = block.sphere(static_cast<int>(lane), i + 1);
      const double turn = norm(b.velocity - a.velocity) * steps[lane] / l,
                   drawn = norm(b.pose.position - a.pose.position) / l - 1;
      if (turn <= largest_turn && drawn <= strain) continue;
      r.steps = done;
      r.failure = stiff_failure_text(members[lane], i, done, steps[lane], turn, drawn, strain);
      r.last = lagged_state(block, static_cast<int>(lane), fiber.aspect_ratio + 1);
      return;
    }
  }

  /// Looks for lanes that blew up since the saved state, `stretch` steps ago.
  void check(const std::vector<double>& saved, double from, int stretch) {
    for (std::size_t lane = 0; lane < members.size(); ++lane) {
      if (!records[members[lane]].failure.empty()) continue;
      if (broken_sphere(block, static_cast<int>(lane), fiber(lane)) < 0) {
        if (options.integrator == Integrator::leapfrog_stiff) check_stiff(lane, from + stretch);
        continue;
      }
      const std::vector<double> now = block.saved();
      block.restore(saved);
      find_break(lane, from, stretch);
      block.restore(now);
    }
  }
};

template <int Dim>
Physics release_physics(const std::vector<Chain<Dim>>& chains, const ReleaseOptions& options) {
  return physics_of<Dim>(
      chains, {.form = options.form, .solved = solved_by(options.integrator), .rolling = options.rolling});
}

/// Samples between two looks at the whole chain: long enough that looking costs little.
int samples_between_checks(int stride) { return 1 + 256 / stride; }

}  // namespace

template <int Dim>
void march_releases(const std::vector<Release<Dim>>& all, const std::vector<std::size_t>& members, int stride,
                    int samples, const ReleaseOptions& options, std::vector<ReleaseRecord<Dim>>& records) {
  std::vector<Chain<Dim>> chains;
  std::vector<double> steps;
  for (const std::size_t i : members) {
    chains.push_back(all[i].chain);
    steps.push_back(release_step(all[i], options));
  }
  March<Dim> march{all,
                   members,
                   options,
                   records,
                   steps,
                   ChainBatch<Dim>(chains, {true, false}, steps, std::vector<double>(chains.size(), 0.0),
                                   release_physics(chains, options), options.instruction_set)};
  for (std::size_t lane = 0; lane < members.size(); ++lane)
    place(march.block, static_cast<int>(lane), all[members[lane]]);
  march.block.synchronize();
  march.record(0);
  const int between = samples_between_checks(stride);
  std::vector<double> saved = march.block.saved();
  int saved_at = 0;
  for (int n = 1; n <= samples; ++n) {
    stop_if_asked(options.asked_to_stop, "stopped in the release");
    march.block.march(stride);
    march.record(static_cast<double>(n) * stride);
    if (n - saved_at < between && n < samples) continue;
    march.check(saved, static_cast<double>(saved_at) * stride, (n - saved_at) * stride);
    if (march.all_broken()) break;
    saved = march.block.saved();
    saved_at = n;
  }
  for (std::size_t lane = 0; lane < members.size(); ++lane) {
    ReleaseRecord<Dim>& r = records[members[lane]];
    if (r.failure.empty()) r.steps = static_cast<double>(samples) * stride;
    r.time_step = steps[lane];
    r.integrator = options.integrator;
    r.work = {.steps = r.steps, .bond_evaluations = r.steps * chains[lane].fiber.aspect_ratio};
    if (r.failure.empty())
      r.last = lagged_state(march.block, static_cast<int>(lane), chains[lane].fiber.aspect_ratio + 1);
  }
}

template void march_releases<2>(const std::vector<Release<2>>&, const std::vector<std::size_t>&, int, int,
                                const ReleaseOptions&, std::vector<ReleaseRecord<2>>&);
template void march_releases<3>(const std::vector<Release<3>>&, const std::vector<std::size_t>&, int, int,
                                const ReleaseOptions&, std::vector<ReleaseRecord<3>>&);

}  // namespace fiberchain::dem
