#include "compare/measure/static_release.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "compare/measure/lane_blocks.hpp"
#include "compare/measure/linear_chain_of.hpp"
#include "compare/measure/ring_down_release.hpp"
#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

std::string case_text(const StaticReleaseRequest& request) {
  return fmt::format("release at aspect ratio {}, load {:g}", request.fiber.aspect_ratio, request.load);
}

void check(const StaticReleaseRequest& request) {
  dem::check(request.fiber);
  if (!(request.load > 0) || !std::isfinite(request.load)) {
    throw InputError(case_text(request) + ": the load must be above 0");
  }
  if (!dem::damped(request.fiber))
    throw InputError(case_text(request) + ": without damping there is no decay to measure");
  if (request.peaks.empty()) throw InputError(case_text(request) + ": no peaks are asked for");
  for (const PeakRange& peaks : request.peaks) {
    if (peaks.first < 0 || peaks.last <= peaks.first) {
      throw InputError(fmt::format("{}: peaks {}..{} are not allowed: give at least two, the first 0 or more",
                                   case_text(request), peaks.first, peaks.last));
    }
  }
}

dem::ReleaseOptions options_of(const StaticReleaseRequest& request) {
  dem::ReleaseOptions options;
  options.form = request.form;
  options.step_ratio = request.step_ratio;
  return options;
}

/// The loaded chain, watched for a little longer than to its last peak: large deflections are faster, never
/// slower.
dem::Release<2> release_of(const StaticReleaseRequest& request) {
  const reference::ChainMode mode = reference::first_bending_mode(linear_chain_of(request.fiber));
  if (!mode.oscillates)
    throw InputError(case_text(request) + ": the first mode is overdamped, there are no peaks");
  const int last = std::ranges::max(request.peaks, {}, &PeakRange::last).last;
  return static_release(request.fiber, mode, request.load, last + 0.5);
}

/// What can go side by side: equal length and steps between samples (the key of a block), asked for alike.
using BlockKey = std::tuple<int, int, dem::BondForm, double>;

BlockKey key_of(const StaticReleaseRequest& request, const dem::Release<2>& release) {
  const dem::ReleaseOptions options = options_of(request);
  const double steps = release.period / (options.samples_per_period * dem::release_step(release, options));
  return {request.fiber.aspect_ratio, static_cast<int>(std::lround(steps)), request.form,
          request.step_ratio.value_or(0)};
}

using Block = std::vector<std::size_t>;

StaticReleaseResult measured(const StaticReleaseRequest& request, const dem::ReleaseRecord<2>& record) {
  StaticReleaseResult result{{}, tip_history(record, dem::fiber_length(request.fiber))};
  const std::vector<Peak> peaks = positive_peaks(result.history);
  try {
    for (const PeakRange& range : request.peaks) result.damping.push_back(damping_from_peaks(peaks, range));
  } catch (const InputError& error) {
    throw InputError(case_text(request) + ": " + error.what());
  }
  return result;
}

void run_block(const std::vector<StaticReleaseRequest>& requests,
               const std::vector<dem::Release<2>>& releases, const Block& block,
               std::vector<StaticReleaseResult>& results) {
  std::vector<dem::Release<2>> together;
  double periods = 0;
  for (const std::size_t i : block) periods = std::max(periods, releases[i].periods);
  for (const std::size_t i : block) {
    together.push_back(releases[i]);
    together.back().periods = periods;  // one length of the march, so that none leaves its lane alone
  }
  const auto records = dem::ring_down<2>(together, options_of(requests[block.front()]));
  for (std::size_t lane = 0; lane < block.size(); ++lane) {
    results[block[lane]] = measured(requests[block[lane]], records[lane]);
  }
}

}  // namespace

std::vector<StaticReleaseResult> static_release_damping(const std::vector<StaticReleaseRequest>& requests,
                                                        const Jobs& jobs) {
  for (const StaticReleaseRequest& request : requests) check(request);
  std::vector<dem::Release<2>> releases(requests.size());
  jobs.run(requests.size(), [&](std::size_t i) { releases[i] = release_of(requests[i]); });
  std::vector<std::optional<BlockKey>> keys;
  for (std::size_t i = 0; i < requests.size(); ++i) keys.emplace_back(key_of(requests[i], releases[i]));
  const std::vector<Block> blocks = lane_blocks(keys);
  std::vector<StaticReleaseResult> results(requests.size());
  jobs.run(blocks.size(), [&](std::size_t i) { run_block(requests, releases, blocks[i], results); });
  return results;
}

}  // namespace fiberchain::compare
