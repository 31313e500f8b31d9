#include "dem/vibration/release.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "dem/bond/branch_steps.hpp"
#include "dem/model/errors.hpp"
#include "dem/model/invalid_key.hpp"
#include "dem/motion/kernels/chain_kernel.hpp"
#include "dem/motion/stiff_limits.hpp"
#include "dem/motion/time_step.hpp"
#include "dem/vibration/choose.hpp"
#include "dem/vibration/release_lanes.hpp"

namespace fiberchain::dem {
namespace {

constexpr double most_steps_per_sample = 1e9;

void require(bool allowed, std::string_view name, double value, std::string_view allowed_text) {
  if (!allowed) throw InvalidInput(fmt::format("{} = {} is not allowed: {}", name, value, allowed_text));
}

template <int Dim>
void check(const Release<Dim>& release, const ReleaseOptions& options) {
  check(release.chain.fiber);
  const std::size_t spheres = release.chain.poses.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == spheres; };
  if (release.start.size() != spheres || !fits(release.velocity.size()) || !fits(release.spin.size())) {
    throw InvalidInput(
        "a release needs a pose, and a velocity and spin or none, for every sphere of its chain");
  }
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  require(positive(release.period), "period", release.period, "it must be finite and greater than 0");
  require(positive(release.periods), "periods", release.periods, "it must be finite and greater than 0");
  require(options.samples_per_period >= 4, "samples_per_period", options.samples_per_period,
          "it must be 4 or more");
  require(!options.step_ratio || positive(*options.step_ratio), "step_ratio", options.step_ratio.value_or(1),
          "it must be greater than 0");
  if (!release.chain.fiber.branches.empty() && options.integrator != Integrator::leapfrog &&
      options.integrator != Integrator::leapfrog_stiff) {
    throw InvalidInput(
        fmt::format("integrator = {} is not allowed: Maxwell branches are built for leapfrog and "
                    "leapfrog-stiff",
                    name(options.integrator)));
  }
  if (release.chain.fiber.rolling_friction > 0 &&
      (options.integrator != Integrator::leapfrog || options.form != BondForm::incremental)) {
    throw InvalidInput(
        fmt::format("integrator = {} is not allowed: rolling friction is built for the leapfrog with the "
                    "incremental form",
                    name(options.integrator)));
  }
}

/// Largest tension of a bond in the state the chain is let go from [N].
template <int Dim>
double start_tension(const Release<Dim>& release) {
  const double l = bond_length(release.chain.fiber), K = bond_stiffness(release.chain.fiber).stretch;
  double largest = 0;
  for (std::size_t i = 0; i + 1 < release.start.size(); ++i) {
    const double length = norm(release.start[i + 1].position - release.start[i].position);
    largest = std::max(largest, K * (length - l));
  }
  return largest;
}

/// Steps between two samples.
template <int Dim>
int steps_per_sample(const Release<Dim>& release, const ReleaseOptions& options) {
  const Fiber& fiber = release.chain.fiber;
  const double interval = release.period / options.samples_per_period;
  const bool stiff = options.integrator == Integrator::leapfrog_stiff;
  const double t_b = bond_time_step(fiber), limit = stiff ? stiff_release_step(release, largest_turn)
                                                          : stable_release_step(fiber, options.integrator);
  double step = std::min(interval, stiff ? stiff_release_step(release, safe_turn) : 0.8 * limit);
  if (options.step_ratio) {
    step = *options.step_ratio * t_b;
    if (step >= limit && !options.allow_unstable) {
      throw InvalidKey(
          "step_ratio",
          fmt::format("step_ratio = {} is not allowed: the largest stable step of this chain is {:.4f} "
                      "t_b",
                      *options.step_ratio, limit / t_b));
    }
  }
  const double steps = std::max(std::ceil(interval / step * (1 - 1e-12)), 1.0);
  if (!(steps <= most_steps_per_sample)) {
    throw InvalidInput(
        fmt::format("step_ratio = {} is not allowed: {:.2g} steps between two samples, at most {:g} are",
                    options.step_ratio.value_or(step / t_b), steps, most_steps_per_sample));
  }
  return static_cast<int>(steps);
}

template <int Dim>
int samples_of(const Release<Dim>& release, const ReleaseOptions& options) {
  return static_cast<int>(std::ceil(release.periods * options.samples_per_period));
}

/// What can share a block: equal length, damped or not, straight or not, rolling or not, and the same numbers
/// of steps and of Maxwell branches.
template <int Dim>
void march_in_blocks(const std::vector<Release<Dim>>& releases, const std::vector<std::size_t>& chosen,
                     const ReleaseOptions& options, std::vector<ReleaseRecord<Dim>>& records) {
  using Counts = std::array<int, 4>;
  std::map<std::tuple<int, bool, bool, bool, int, int, Counts>, std::vector<std::size_t>> groups;
  for (const std::size_t i : chosen) {
    const Release<Dim>& r = releases[i];
    const BranchSteps own = branch_steps(r.chain.fiber, 0, Dim);
    groups[{r.chain.fiber.aspect_ratio, damped(r.chain.fiber), r.chain.natural.empty(),
            r.chain.fiber.rolling_friction > 0, steps_per_sample(r, options), samples_of(r, options),
            Counts{own.stretch, own.shear, own.twist, own.bend}}]
        .push_back(i);
  }
  const std::size_t width = chain_kernel(built_physics[0], options.instruction_set).width;
  for (const auto& [kind, members] : groups) {
    for (std::size_t first = 0; first < members.size(); first += width) {
      const std::size_t end = std::min(first + width, members.size());
      march_releases(releases, {members.begin() + first, members.begin() + end}, std::get<4>(kind),
                     std::get<5>(kind), options, records);
    }
  }
}

}  // namespace

double stable_release_step(const Fiber& fiber, Integrator integrator) {
  switch (integrator) {
    case Integrator::leapfrog:
      return stable_time_step(fiber);
    case Integrator::leapfrog_damped:
      return undamped_time_step(fiber);
    default:
      return std::numeric_limits<double>::infinity();
  }
}

template <int Dim>
double swing(const Release<Dim>& release) {
  if (release.start.empty()) return 0;
  const double moved = norm(release.start.back().position - release.chain.poses.back().position);
  const double speed = release.velocity.empty() ? 0.0 : norm(release.velocity.back());
  return std::max(moved, speed * release.period / (2 * std::numbers::pi)) / fiber_length(release.chain.fiber);
}

template <int Dim>
double stiff_release_step(const Release<Dim>& release, double turn) {
  // the tip of a beam turns by about 1.4 a/L as it deflects by a
  const double fastest = 1.4 * swing(release) * 2 * std::numbers::pi / release.period;
  return std::min(fastest > 0 ? turn / fastest : std::numeric_limits<double>::infinity(),
                  step_for_tension(release.chain.fiber, start_tension(release), stiff_beta, {true, false}));
}

template <int Dim>
double release_step(const Release<Dim>& release, const ReleaseOptions& options) {
  return release.period /
         (static_cast<double>(options.samples_per_period) * steps_per_sample(release, options));
}

template <int Dim>
std::vector<ReleaseRecord<Dim>> ring_down(const std::vector<Release<Dim>>& releases,
                                          const ReleaseOptions& options) {
  std::vector<ReleaseRecord<Dim>> records(releases.size());
  if (options.integrator == Integrator::automatic) {
    for (std::size_t i = 0; i < releases.size(); ++i) {
      const IntegratorChoice choice = choose_integrator(releases[i], options);
      ReleaseOptions own = options;
      own.integrator = choice.integrator;
      own.step_ratio = choice.step_ratio;
      records[i] = ring_down<Dim>({releases[i]}, own)[0];
      records[i].reason = choice.reason;
    }
    return records;
  }
  std::vector<std::size_t> marched;
  for (std::size_t i = 0; i < releases.size(); ++i) {
    check(releases[i], options);
    if (is_leapfrog(options.integrator)) {
      marched.push_back(i);
    } else {
      records[i] = integrate_release(releases[i], steps_per_sample(releases[i], options),
                                     samples_of(releases[i], options), options);
    }
  }
  march_in_blocks(releases, marched, options, records);
  return records;
}

template double swing<2>(const Release<2>&);
template double swing<3>(const Release<3>&);
template double stiff_release_step<2>(const Release<2>&, double);
template double stiff_release_step<3>(const Release<3>&, double);
template double release_step<2>(const Release<2>&, const ReleaseOptions&);
template double release_step<3>(const Release<3>&, const ReleaseOptions&);
template std::vector<ReleaseRecord<2>> ring_down<2>(const std::vector<Release<2>>&, const ReleaseOptions&);
template std::vector<ReleaseRecord<3>> ring_down<3>(const std::vector<Release<3>>&, const ReleaseOptions&);

}  // namespace fiberchain::dem
