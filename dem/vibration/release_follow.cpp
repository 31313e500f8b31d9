#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/model/errors.hpp"
#include "dem/motion/cvode.hpp"
#include "dem/motion/implicit.hpp"
#include "dem/vibration/release_lanes.hpp"

namespace fiberchain::dem {
namespace {

template <int Dim>
ChainState<Dim> start_of(const Release<Dim>& release) {
  ChainState<Dim> state = at_rest<Dim>(release.start);
  if (!release.velocity.empty()) state.velocity = release.velocity;
  if (!release.spin.empty()) state.spin = release.spin;
  state.velocity[0] = {};
  state.spin[0] = {};
  return state;
}

template <int Dim>
TipSample<Dim> sample(const Release<Dim>& release, const ChainState<Dim>& state, double time, bool energy) {
  return {time, state.poses.back().position, state.velocity.back(),
          energy ? total_energy(release.chain, state) : 0.0};
}

/// The farthest that a sphere starts from its place at rest, or goes in a period at its first speed.
template <int Dim>
double deflection(const Release<Dim>& release, const ChainState<Dim>& state) {
  double largest = 0;
  for (std::size_t i = 0; i < state.poses.size(); ++i) {
    largest = std::max({largest, norm(state.poses[i].position - release.chain.poses[i].position),
                        norm(state.velocity[i]) * release.period / (2 * std::numbers::pi)});
  }
  return largest > 0 ? largest : fiber_length(release.chain.fiber);
}

template <int Dim>
CvodeTolerance tolerance_of(const Release<Dim>& release, const ChainState<Dim>& state, double relative) {
  const double size = deflection(release, state);
  return {relative, size, size / fiber_length(release.chain.fiber), release.period / (2 * std::numbers::pi)};
}

/// Records what `at(n)`, the state at sample n, gives until it throws.
template <int Dim, class At>
void record(ReleaseRecord<Dim>& record, const Release<Dim>& release, int samples,
            const ReleaseOptions& options, const At& at) {
  const double interval = record.time_step;
  try {
    for (int n = 0; n <= samples; ++n) {
      stop_if_asked(options.asked_to_stop, "stopped in the release");
      record.last = at(n);
      record.samples.push_back(sample(release, record.last, n * interval, options.energy));
    }
  } catch (const Diverged& error) {
    record.failure = error.what();
  }
}

}  // namespace

template <int Dim>
ReleaseRecord<Dim> integrate_release(const Release<Dim>& release, int stride, int samples,
                                     const ReleaseOptions& options) {
  const double interval = release.period / options.samples_per_period;
  ReleaseRecord<Dim> result{};
  result.integrator = options.integrator;
  result.time_step = interval;
  const ChainState<Dim> start = start_of(release);
  const Boundary<Dim> clamp{{0}, {}};
  if (options.integrator == Integrator::cvode) {
    CvodeMotion<Dim> motion(release.chain, clamp, start, tolerance_of(release, start, options.tolerance));
    record(result, release, samples, options, [&](int n) { return motion.at(n * interval); });
    result.work = motion.work();
  } else {
    ImplicitMotion<Dim> motion(release.chain, clamp, start);
    record(result, release, samples, options, [&](int n) {
      for (int k = 0; n > 0 && k < stride; ++k) motion.step(interval / stride);
      return motion.state();
    });
    result.work = motion.work();
  }
  result.steps = result.work.steps;
  result.time_step = interval * samples / std::max(result.steps, 1.0);
  return result;
}

template ReleaseRecord<2> integrate_release<2>(const Release<2>&, int, int, const ReleaseOptions&);
template ReleaseRecord<3> integrate_release<3>(const Release<3>&, int, int, const ReleaseOptions&);

}  // namespace fiberchain::dem
